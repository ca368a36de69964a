// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lamina/sweep/sweep.hpp"

namespace lamina {

/// Nine numbers of a turn, row by row, and the origin: how Abaqus places a sketch.
using SketchTransform = std::array<double, 12>;

/// Places the profile of a sweep whose first line runs from `start` to `end` upright across that line, at the
/// bottom of the bead: the rows of Rx(-90 deg) Rz(atan(dx / dy)), then start and bottom ([Vega2023,
/// eq. 1], with the sign of its Rx put right).
/// @param start, end  apart
SketchTransform profileTransform(const Point2& start, const Point2& end, double bottom_mm);

/// Whether the script states RIGHT as the orientation of a sweep's sketches, else LEFT, for a first line from
/// `start` to `end`: it does for lines along +x, along -y and towards +x and -y, and by the side of the
/// origin on which the others cross the x axis.
bool isSketchRight(const Point2& start, const Point2& end);

/// The Python script with which Abaqus/CAE builds the part of the sweeps [Vega2023, section 3.2.2]: one solid
/// sweep each, on datum planes at the bottoms and tops of the layers. Numbers have 3 decimals [mm]; the part
/// is moved in x and y so that its middle lines begin at 2 mm.
/// @throws InvalidInput if there is no sweep, or one is not level
std::string abaqusScript(const std::vector<Sweep>& sweeps);

}  // namespace lamina
