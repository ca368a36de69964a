// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/trailing_trim.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kMostSteps = 1e5;

}  // namespace

std::optional<TrimSettings> trimOf(const LoopSettings& settings, double step_mm, double growth) {
  if (settings.trim == 0.0 || settings.sensor_behind_mm == 0.0) return std::nullopt;
  TrimSettings trim;
  trim.behind_mm = settings.sensor_behind_mm + settings.trim_lead_mm;
  trim.gain_per_mm = settings.trim / trim.behind_mm;
  trim.step_mm = step_mm;
  trim.growth = growth;
  return trim;
}

TrailingTrim::TrailingTrim(const TrimSettings& settings) : settings_(settings) {
  const double steps = settings.behind_mm / settings.step_mm;
  if (!(settings.step_mm > 0.0) || !(steps > 0.0) || steps > kMostSteps)
    throw InvalidInput("a sensor " + numberText(settings.behind_mm) + " mm behind the nozzle is read every " +
                       numberText(settings.step_mm) +
                       " mm; expected positive lengths, and at most 1e5 steps");
  under_way_.assign(static_cast<std::size_t>(std::max(1.0, std::round(steps))), 0.0);
}

double TrailingTrim::advance(std::optional<double> relative_error) {
  const double seen = under_way_[next_];
  if (relative_error && std::isfinite(*relative_error)) {
    const double expected_change = settings_.growth * (trim_ - seen);
    trim_ -= settings_.gain_per_mm * settings_.step_mm * (*relative_error + expected_change);
    trim_ = std::clamp(trim_, -settings_.range, settings_.range);
  }
  under_way_[next_] = trim_;
  next_ = (next_ + 1) % under_way_.size();
  return trim_;
}

void TrailingTrim::replace(double trim) {
  trim_ = trim;
  const std::size_t count = under_way_.size();
  under_way_[(next_ + count - 1) % count] = trim;
}

}  // namespace lamina
