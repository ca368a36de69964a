// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/layer_cells.hpp"

namespace lamina {

/// What a low-pass does at the ends of a path.
enum class PathEnds { Reflected, Joined };

/// Places along a path at which values stand.
struct Stations {
  std::vector<double> along_mm;  ///< ascending, within the path; need not be equally spaced
  double length_mm = 0.0;        ///< of the path
  PathEnds ends = PathEnds::Reflected;
};

/// Gaussian low-pass of values along a path, cut off at four standard deviations: each station counts by the
/// length it stands for. A constant stays as it is. Costs stations times those within reach; equal stations
/// share one kernel.
/// @param sigma_mm  standard deviation; 0 changes nothing
/// @throws InvalidInput if the stations do not ascend within the length, or are not as many as values
std::vector<double> lowPassed(const std::vector<double>& values, const Stations& stations, double sigma_mm);

/// The same along each path of a layer, and then across: the cells beside each on neighbouring beads
/// (`CellsBeside`) count by the same Gaussian of their distance. Other layers have no part in it.
std::vector<double> lowPassed(const std::vector<double>& values, const LayerCells& cells, double sigma_mm);

/// The stations of a run of cells.
Stations stationsOf(const LayerCells& cells, const CellRun& run);

}  // namespace lamina
