// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// How runs are connected along a border.
struct BorderConnection {
  double width_mm = 0.1;    ///< plan width of the bead of a connection
  double reach_mm = 0.8;    ///< greatest distance of the ends of runs from the border
  double longest_mm = 0.0;  ///< greatest length of a connection along the border
  /// Greatest plan area of a whole connection, from the end of one run to the start of the other.
  double most_mm2 = 0.0;
};

/// Joins runs by a bead along the outline if the end of one run and the start of another are near the same
/// outline and close to each other along it. The bead has a width of its own and takes the shorter direction
/// round the outline. A thin bead along the border needs hardly any material and saves a stop and a start of
/// the process. From the end of a run, the nearest end of the runs still to be deposited is chosen, and that
/// run is reversed if need be. If there is none within reach, the next run in the given order follows without
/// connection.
///
/// @param runs    in the order of deposition; closed runs, and those without widths, are not connected
/// @param border  regions along whose outlines connections run
std::vector<FillPath> connectAlongBorder(std::vector<FillPath> runs, const Regions& border,
                                         const BorderConnection& connection);

}  // namespace lamina
