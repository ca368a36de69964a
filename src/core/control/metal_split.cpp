// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/metal_split.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

/// Speeds that window and heat leave at a cell [mm/s].
struct SpeedRange {
  double least;
  double greatest;
};

SpeedRange speedsAt(double planned, PowerSource source, const LoopSettings& settings) {
  SpeedRange range{settings.least_speed_mm_s, settings.greatest_speed_mm_s};
  if (source == PowerSource::Fixed) {
    range.least = std::max(range.least, planned / (1.0 + settings.heat));
    range.greatest = std::min(range.greatest, planned / std::max(1e-6, 1.0 - settings.heat));
  }
  if (!(range.least <= range.greatest))
    throw InvalidInput("a cell is planned at " + numberText(planned) +
                       " mm/s; expected a speed from which loop.heat leads into " +
                       numberText(settings.least_speed_mm_s) + " to " +
                       numberText(settings.greatest_speed_mm_s) +
                       " mm/s (loop.least_speed_mm_s, loop.greatest_speed_mm_s)");
  return range;
}

}  // namespace

MetalCorrection metalSplit(const LayerCells& cells, const std::vector<double>& amount, PowerSource source,
                           const LoopSettings& settings) {
  if (settings.speed_exponent == 0.0)
    throw InvalidConfig("loop.speed_exponent is 0; expected a negative power of the travel speed");
  if (settings.least_speed_mm_s > settings.greatest_speed_mm_s)
    throw InvalidConfig("loop.least_speed_mm_s is " + numberText(settings.least_speed_mm_s) +
                        " mm/s; expected at most loop.greatest_speed_mm_s, " +
                        numberText(settings.greatest_speed_mm_s) + " mm/s");
  MetalCorrection split;
  split.wire = meanOverCells(cells, amount);
  std::size_t limited = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double planned = cells.speed_mm_s[i];
    const double left = (1.0 + amount[i]) / (1.0 + split.wire);
    const double wanted = planned * std::pow(left, 1.0 / settings.speed_exponent);
    const SpeedRange range = speedsAt(planned, source, settings);
    const double speed = std::clamp(wanted, range.least, range.greatest);
    if (speed != wanted) ++limited;
    split.speed_mm_s.push_back(speed);
    const double grown = (1.0 + split.wire) * std::pow(speed / planned, settings.speed_exponent) - 1.0;
    split.amount.push_back(speed == wanted ? amount[i] : grown);
    // Power that goes all the way with the speed leaves heat per length as it is planned.
    split.power.push_back(source == PowerSource::Follows ? speed / planned - 1.0 : 0.0);
  }
  if (cells.size() > 0)
    split.limited_share = static_cast<double>(limited) / static_cast<double>(cells.size());
  return split;
}

}  // namespace lamina
