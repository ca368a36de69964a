// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/layer_cells.hpp"

namespace lamina {

/// How a low-pass continues values beyond the ends of a path: by mirrored values, or, on a closed path, by
/// the values at the other end.
enum class PathEnds { Reflected, Joined };

/// Positions along a path at which values are given.
struct Stations {
  std::vector<double> along_mm;  ///< ascending, within the path; spacing may vary
  double length_mm = 0.0;        ///< length of the path
  PathEnds ends = PathEnds::Reflected;
};

/// Gaussian low-pass of values along a path, truncated at four standard deviations. Each station is weighted
/// by the length for which it stands. Constant values stay unchanged. The cost is the number of stations
/// times the number within reach of one; for equally spaced stations the weights are computed only once.
/// @param sigma_mm  standard deviation; 0 changes nothing
/// @throws InvalidInput if the stations do not ascend within the length, or there is not one for each value
std::vector<double> lowPassed(const std::vector<double>& values, const Stations& stations, double sigma_mm);

/// Low-pass of one value per cell of a layer. First the values along each path are filtered as above, then
/// those across the beads, where the cells on neighbouring beads (`CellsBeside`) are weighted by the same
/// Gaussian of their distance.
std::vector<double> lowPassed(const std::vector<double>& values, const LayerCells& cells, double sigma_mm);

/// The middles of a run's cells, as stations.
Stations stationsOf(const LayerCells& cells, const CellRun& run);

}  // namespace lamina
