// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// How runs are connected along a border.
struct BorderConnection {
  double width_mm = 0.1;    ///< plan width of the bead deposited on the way
  double reach_mm = 0.8;    ///< how far from the border the ends of runs may be
  double longest_mm = 0.0;  ///< way along the border
  double most_mm2 = 0.0;    ///< plan area of all connections together, from end to end of the runs
};

/// Joins runs where the ends of two lie near the same outline and the way along that outline is short enough:
/// the shorter way round, as a bead of its own width. A thin bead along the border costs hardly any material
/// and saves a stop and a start of the process. From the end of each run the nearest end of those still to be
/// deposited is taken, turned round if need be; where there is none, the next run in the given order begins
/// anew.
///
/// @param runs    in the order they are deposited; closed runs, and those without widths, stay by themselves
/// @param border  along whose outlines the connections run
std::vector<FillPath> connectAlongBorder(std::vector<FillPath> runs, const Regions& border,
                                         const BorderConnection& connection);

}  // namespace lamina
