// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/whole_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lamina/base/error.hpp"
#include "program/number_text.hpp"

namespace lamina {
namespace {

constexpr double kGreatestError = 0.02;  // of a speed
constexpr double kSameError = 1e-9;      // two units that are as good as each other

}  // namespace

RoundedSpeed roundedSpeed(double feed_mm_s, const std::vector<SpeedUnit>& units) {
  RoundedSpeed best;
  double least = std::numeric_limits<double>::infinity();
  for (const SpeedUnit& unit : units) {
    const double steps = std::max(1.0, std::round(feed_mm_s / (unit.mm_s * unit.step)));
    const double value = std::min(steps * unit.step, unit.greatest);
    const double error = std::abs(value * unit.mm_s / feed_mm_s - 1.0);
    if (error >= least - kSameError) continue;
    least = error;
    best = {unit, value};
  }
  if (!(least <= kGreatestError))
    throw InvalidInput("a feed is " + std::to_string(feed_mm_s) +
                       " mm/s; the nearest that can be written is " + trimmedDecimals(best.value, 3) + " " +
                       best.unit.name + ", " + trimmedDecimals(100.0 * least, 1) +
                       " % off, expected 2 % at most");
  return best;
}

}  // namespace lamina
