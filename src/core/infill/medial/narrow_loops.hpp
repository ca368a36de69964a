// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "infill/contour/contour_loop.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Closed loops that fill a narrow region by beads half as wide as it is, out along one side of its medial
/// axis and back along the other: one loop round each connected axis and one more in each of its holes. Where
/// the region is about as thick all over, and without holes, the loop runs along its border.
std::vector<ContourLoop> narrowLoops(const Region& region, double pitch_mm);

}  // namespace lamina
