// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lamina/sweep/sweep.hpp"

namespace lamina {

/// Pose of a sketch as Abaqus describes it: the nine numbers of a rotation matrix, row by row, then the
/// origin.
using SketchTransform = std::array<double, 12>;

/// The pose of the profile of a sweep whose first line runs from `start` to `end`: vertical, across that
/// line, with the origin at `start` and at the bottom of the bead. The rotation is Rx(-90 deg) Rz(a) with tan
/// a = dx / dy ([Vega2023, eq. 1], with the sign of its Rx corrected).
/// @param start, end  must differ
SketchTransform profileTransform(const Point2& start, const Point2& end, double bottom_mm);

/// Whether the script gives RIGHT as the orientation of a sweep's sketches, rather than LEFT, if its first
/// line runs from `start` to `end`: always for lines along +x, along -y or between these directions, never
/// for lines along -x, along +y or between these. For others it depends on the side of the origin on which
/// the line crosses the x axis.
bool isSketchRight(const Point2& start, const Point2& end);

/// The Python script by which Abaqus/CAE builds the sweeps as a part [Vega2023, section 3.2.2]: a solid sweep
/// for each, on datum planes at the bottoms and tops of the layers. Numbers have 3 decimals [mm]; the part
/// is moved in x and y so that the least coordinates of its middle lines are 2 mm.
/// @throws InvalidInput if there is no sweep, or one is not level
std::string abaqusScript(const std::vector<Sweep>& sweeps);

}  // namespace lamina
