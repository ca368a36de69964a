// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Memory [bytes] to solve so many elements and nodes, from above.
double stiffnessBytes(double elements, double nodes);

/// Refuses work that does not fit in memory.
/// @param needed  [bytes]
/// @param limit_mb  [MiB]; 0 for what the machine has free
/// @throws InvalidInput  naming what is needed, what may be used, and the voxel that would fit
void requireMemory(double needed, int limit_mb, double voxel_mm);

}  // namespace lamina
