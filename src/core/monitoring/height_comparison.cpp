// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/height_comparison.hpp"

#include <cmath>
#include <utility>

namespace lamina {

HeightComparison compareHeights(const MeasuredSurface& measured, const ExpectedSurface& expected,
                                HeightMap deviation) {
  HeightStatistics statistics;
  double sum = 0.0;
  double squares = 0.0;
  for (const std::size_t cell : expected.topCells()) {
    const double error = measured.heightInPass(cell) - expected.heights().at(cell);
    if (std::isnan(error)) continue;
    deviation.set(cell, error);
    ++statistics.cells;
    sum += error;
    squares += error * error;
    if (std::abs(error) > std::abs(statistics.worst_mm)) statistics.worst_mm = error;
  }
  if (statistics.cells > 0) {
    const double count = static_cast<double>(statistics.cells);
    statistics.mean_mm = sum / count;
    statistics.rms_mm = std::sqrt(squares / count);
    statistics.coverage = count / static_cast<double>(expected.topCells().size());
  }
  return {statistics, std::move(deviation)};
}

}  // namespace lamina
