// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/process_plan.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

bool isAmount(double value) { return value >= 0.0 && std::isfinite(value); }

void requireSignals(const ProcessSignals& signals, std::size_t point) {
  if (!isAmount(signals.flow_mm3_s))
    throw InvalidInput("point " + std::to_string(point) + " has a flow of " + numberText(signals.flow_mm3_s) +
                       " mm3/s; must be a finite number of 0 or more");
  for (const ProcessLevel level : kAllProcessLevels)
    if (signals.levels.has(level) && !isAmount(signals.levels[level]))
      throw InvalidInput("point " + std::to_string(point) + " has a " + nameOf(level) + " of " +
                         numberText(signals.levels[level]) +
                         "; must be a finite number of 0 or more, or NaN for none");
}

void requireChunk(const ProcessChunk& chunk) {
  if (chunk.points.empty()) throw InvalidInput("a process without points; expected one at least");
  if (!std::isfinite(chunk.valid_until_s))
    throw InvalidInput("a process is valid until " + numberText(chunk.valid_until_s) +
                       " s; must be a finite time");
  for (std::size_t i = 0; i < chunk.points.size(); ++i) {
    const double time_s = chunk.points[i].time_s;
    if (!std::isfinite(time_s) || (i > 0 && time_s < chunk.points[i - 1].time_s))
      throw InvalidInput("point " + std::to_string(i) + " of a process is at " + numberText(time_s) +
                         " s; must be a finite time, not before the point before");
    requireSignals(chunk.points[i].signals, i);
  }
}

}  // namespace

void ProcessPlan::accept(const ProcessChunk& chunk) {
  requireChunk(chunk);
  const double first_s = chunk.points.front().time_s;
  const auto kept = std::lower_bound(points_.begin(), points_.end(), first_s,
                                     [](const Point& point, double time_s) { return point.time_s < time_s; });
  const auto before = static_cast<std::size_t>(kept - points_.begin());
  if (before + chunk.points.size() + 1 > kMostPoints)
    throw InvalidInput("a process of " + std::to_string(chunk.points.size()) + " points behind " +
                       std::to_string(before) + "; at most " + std::to_string(kMostPoints) + " are kept");
  points_.erase(kept, points_.end());
  if (!points_.empty() && first_s > valid_until_s_ + kMeet) {
    while (!points_.empty() && points_.back().time_s >= valid_until_s_) points_.pop_back();
    points_.push_back({valid_until_s_, std::nullopt});
  }
  for (const PlannedProcess& point : chunk.points) points_.push_back({point.time_s, point.signals});
  valid_until_s_ = std::min(chunk.valid_until_s, chunk.points.back().time_s + kLongestHold);
}

std::optional<ProcessSignals> ProcessPlan::at(double time_s) const {
  if (!(time_s <= valid_until_s_)) return std::nullopt;
  const auto after = std::upper_bound(points_.begin(), points_.end(), time_s,
                                      [](double time, const Point& point) { return time < point.time_s; });
  if (after == points_.begin()) return std::nullopt;
  const Point& here = *std::prev(after);
  if (!here.signals || after == points_.end() || !after->signals) return here.signals;
  const double span_s = after->time_s - here.time_s;
  return between(*here.signals, *after->signals, (time_s - here.time_s) / span_s);
}

void ProcessPlan::forget(double time_s) {
  while (points_.size() > 1 && points_[1].time_s <= time_s) points_.pop_front();
}

}  // namespace lamina
