// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Parallel lines at the requested angle and spacing, joined along the outline into runs to and fro. One line
/// passes through the origin, so that lines of layers with the same angle lie above each other. Neighbouring
/// lines are joined if the outline leads from one to the other within `longestLink`. Parts of a region that
/// lie between two lines get no line.
std::vector<FillPath> rasterRuns(const Regions& centre_lines, const InfillRequest& request);

/// The same runs joined further: the end of a run is connected along the outline to the end of another if no
/// line ends in between. Shorter connections are made first.
/// @param longest_mm  greatest length of a connection
std::vector<FillPath> joinedRasterRuns(const Regions& centre_lines, const InfillRequest& request,
                                       double longest_mm);

/// `variableWidthRuns` if the fill is solid, otherwise `rasterRuns` where centre lines may run.
std::vector<FillPath> zigzag(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
