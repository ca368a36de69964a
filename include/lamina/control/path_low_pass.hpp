// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/layer_cells.hpp"

namespace lamina {

/// How a low-pass continues values beyond the ends of a path: mirrored, or by those at the other end.
enum class PathEnds { Reflected, Joined };

/// Positions along a path at which values are given.
struct Stations {
  std::vector<double> along_mm;  ///< ascending, within the path; need not be equally spaced
  double length_mm = 0.0;        ///< of the path
  PathEnds ends = PathEnds::Reflected;
};

/// Gaussian low-pass of values along a path, truncated at four standard deviations. The weight of a station
/// includes the length for which it stands. A constant stays unchanged. The cost is the number of stations
/// times that of stations within reach; equally spaced stations share one kernel.
/// @param sigma_mm  standard deviation; 0 changes nothing
/// @throws InvalidInput if the stations do not ascend within the length, or are not as many as values
std::vector<double> lowPassed(const std::vector<double>& values, const Stations& stations, double sigma_mm);

/// The same along each path of a layer, then across beads: the cells on neighbouring beads (`CellsBeside`)
/// are weighted by the same Gaussian of their distance. Other layers do not contribute.
std::vector<double> lowPassed(const std::vector<double>& values, const LayerCells& cells, double sigma_mm);

/// The stations of a run of cells.
Stations stationsOf(const LayerCells& cells, const CellRun& run);

}  // namespace lamina
