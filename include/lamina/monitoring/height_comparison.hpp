// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/monitoring/expected_surface.hpp"
#include "lamina/monitoring/measured_surface.hpp"

namespace lamina {

/// What a layer measured against what was planned, over the expected surface's top cells.
struct HeightStatistics {
  double mean_mm = 0.0;   ///< measured less expected; 0 if nothing was seen
  double rms_mm = 0.0;    ///< root of the mean square
  double worst_mm = 0.0;  ///< the one of the largest magnitude, with its sign
  double coverage = 0.0;  ///< part of the top cells that were seen
  std::size_t cells = 0;  ///< seen
};

/// Compares what the present pass saw with the latest layer, and writes the cells' deviations over what
/// `deviation` held there.
///
/// @param deviation  measured less expected [mm], same grid; returned with the layer's cells replaced
struct HeightComparison {
  HeightStatistics statistics;
  HeightMap deviation;
};
HeightComparison compareHeights(const MeasuredSurface& measured, const ExpectedSurface& expected,
                                HeightMap deviation);

}  // namespace lamina
