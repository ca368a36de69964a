// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Upper estimate of the memory [bytes] that `solveStiffness` needs.
/// @param elements, nodes numbers of elements and nodes
double stiffnessBytes(double elements, double nodes);

/// Refuses work that does not fit in memory.
/// @param needed  [bytes]
/// @param limit_mb  memory that may be used [MiB]; 0 for the free memory of the computer
/// @throws InvalidInput naming the memory needed, the memory that may be used, and the voxel size that would
///   fit
void requireMemory(double needed, int limit_mb, double voxel_mm);

}  // namespace lamina
