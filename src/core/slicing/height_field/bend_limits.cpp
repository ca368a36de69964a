// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/height_field/bend_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace lamina {
namespace {

/// Calls visit(half, corners) for each half cell with material.
template <class Visit>
void forMaterial(const HeightGrid& cells, const TopSurface& top, const Visit& visit) {
  for (std::size_t half = 0; half < top.over_half.size(); ++half)
    if (top.over_half[half]) visit(half, cornersOfHalf(cells, half));
}

/// Mean and range of the bend where there is material.
struct BendStatistics {
  double mean = 0.0;
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
};

BendStatistics statisticsOf(const HeightField& field, const std::vector<double>& log_factor,
                            const TopSurface& top) {
  BendStatistics statistics;
  std::size_t count = 0;
  forMaterial(field.cells, top, [&](std::size_t, const std::array<std::size_t, 3>& corners) {
    for (const std::size_t at : corners) {
      const double value = log_factor[at];
      statistics.mean += value;
      statistics.least = std::min(statistics.least, value);
      statistics.greatest = std::max(statistics.greatest, value);
      ++count;
    }
  });
  statistics.mean /= static_cast<double>(std::max<std::size_t>(count, 1));
  return statistics;
}

}  // namespace

FactorRange factorRange(const HeightField& field, const TopSurface& top) {
  const BendStatistics statistics = statisticsOf(field, field.factor, top);
  return {statistics.least, statistics.greatest};
}

double steepestSlope(const HeightField& field, const TopSurface& top) {
  double steepest = 0.0;
  for (std::size_t half = 0; half < top.over_half.size(); ++half)
    steepest = std::max(steepest, steepestSlope(field.factor, field.cells, top, half));
  return steepest;
}

double steepestSlope(const std::vector<double>& factor, const HeightGrid& cells, const TopSurface& top,
                     std::size_t half) {
  if (!top.over_half[half]) return 0.0;
  const std::array<std::size_t, 3> corners = cornersOfHalf(cells, half);
  std::array<double, 3> factors{};
  double highest = 0.0;  // of the level layers: a quotient of linear functions has its greatest at a corner
  for (std::size_t i = 0; i < 3; ++i) {
    factors[i] = factor[corners[i]];
    highest = std::max(highest, (*top.over_half[half])[i] / factors[i]);
  }
  return highest * slopeOfHalf(factors, cells.cell_mm);
}

LimitedBend limitedBend(HeightGrid cells, double base_mm, const std::vector<double>& log_factor,
                        const TopSurface& top, const HeightFieldSettings& settings) {
  LimitedBend bend{{cells, base_mm, std::vector<double>(log_factor.size(), 1.0)}, 1.0};
  const BendStatistics asked = statisticsOf(bend.field, log_factor, top);
  const double thin = std::log(settings.min_thickness);
  const double thick = std::log(settings.max_thickness);
  const auto take = [&](double share) {
    double shift = -share * asked.mean;
    shift = std::min(shift, thick - share * asked.greatest);
    shift = std::max(shift, thin - share * asked.least);
    for (std::size_t i = 0; i < log_factor.size(); ++i)
      bend.field.factor[i] = std::exp(share * log_factor[i] + shift);
    bend.share = share;
  };
  const double range = asked.greatest - asked.least;
  const double allowed = std::tan(settings.max_slope_deg * M_PI / 180.0);
  const double most = range > thick - thin ? (thick - thin) / range : 1.0;
  take(most);
  if (steepestSlope(bend.field, top) <= allowed) return bend;
  double fits = 0.0;
  double exceeds = most;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (fits + exceeds);
    take(middle);
    (steepestSlope(bend.field, top) <= allowed ? fits : exceeds) = middle;
  }
  take(fits);
  return bend;
}

}  // namespace lamina
