// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/monitoring/expected_surface.hpp"
#include "lamina/monitoring/measured_surface.hpp"

namespace lamina {

/// Differences between the measured and the planned height of a layer, over the top cells of the expected
/// surface.
struct HeightStatistics {
  double mean_mm = 0.0;   ///< measured less expected; 0 if nothing was seen
  double rms_mm = 0.0;    ///< root of the mean square
  double worst_mm = 0.0;  ///< difference of the largest magnitude, with its sign
  double coverage = 0.0;  ///< share of the top cells that was seen, 0 to 1
  std::size_t cells = 0;  ///< number of top cells seen
};

/// A layer's statistics, and the deviations of all cells so far.
struct HeightComparison {
  HeightStatistics statistics;
  HeightMap deviation;  ///< measured less expected [mm]
};

/// Compares the heights that were measured in the present pass with those of the latest layer.
/// @param deviation  of the layers before, measured less expected [mm], on the same grid; it is returned with
///   the values of this layer's cells replaced where they were seen
HeightComparison compareHeights(const MeasuredSurface& measured, const ExpectedSurface& expected,
                                HeightMap deviation);

}  // namespace lamina
