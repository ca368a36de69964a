// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/speed_plan.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

double squared(double value) { return value * value; }

}  // namespace

SpeedPlan::SpeedPlan(const JointCurve& curve, const Waits& waits)
    : curve_(&curve), averaging_s_(waits.averaging_s), cells_(curveCells(curve)) {
  planSpeeds();
  buildTimeline(waits);
}

void SpeedPlan::planSpeeds() {
  speed2_.assign(cells_.size() + 1, 0.0);
  limitNodes();
  for (std::size_t i = cells_.size(); i-- > 1;) {
    const double length = cells_[i].end - cells_[i].start;
    speed2_[i] = std::min(speed2_[i], limitsOf(i).reachable(speed2_[i + 1], length));
  }
  for (std::size_t i = 0; i + 1 < cells_.size(); ++i) {
    const double length = cells_[i].end - cells_[i].start;
    speed2_[i + 1] = std::min(speed2_[i + 1], limitsOf(i).reachable(speed2_[i], length));
  }
}

void SpeedPlan::limitNodes() {
  double before = 0.0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const double here = limitsOf(i).speed2;
    const bool is_rest = cells_[i].start == 0.0 && curve_->isRest(cells_[i].span);
    speed2_[i] = is_rest ? 0.0 : std::min(before, here);
    before = here;
  }
}

double SpeedPlan::waitAt(std::size_t station, const Waits& waits) const {
  const auto laysOn = [this](std::size_t span) {
    return span < curve_->spanCount() && curve_->spanEnd(span).area_mm2 > 0.0;
  };
  const bool lays_before = station > 0 && laysOn(station - 1);
  const bool lays_after = laysOn(station);
  double wait_s = waits.averaging_s;
  if (station == 0) wait_s += waits.at_start;
  if (lays_before && !lays_after) wait_s += waits.after_bead;
  if (lays_after && !lays_before) wait_s += waits.before_bead;
  return wait_s;
}

void SpeedPlan::buildTimeline(const Waits& waits) {
  const auto appendWait = [&](std::uint32_t span, double along, std::size_t station) {
    timeline_.append({0.0, curve_, along, 0.0, 0.0, span, PhaseKind::Wait}, waitAt(station, waits));
  };
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const CurveCell& cell = cells_[i];
    if (cell.start == 0.0 && curve_->isRest(cell.span)) appendWait(cell.span, 0.0, cell.span);
    appendCell(timeline_, i, {curve_, cell.span, cell.start, std::sqrt(speed2_[i])}, speed2_[i + 1]);
  }
  if (cells_.empty()) return;
  const std::uint32_t last = cells_.back().span;
  appendWait(last, curve_->length(last), last + 1);
}

/// From a place in a cell to its end. In a rounding the squared speed is linear; on the straight part the
/// fastest profile is run.
void SpeedPlan::appendCell(Timeline& out, std::size_t cell, MotionPlace from, double exit2) const {
  const double length = cells_[cell].end - from.along;
  if (cells_[cell].part != 0) return out.appendStretch(from, length, exit2);
  const CellLimits limits = limitsOf(cell);
  const double a = limits.braking(0.0);
  const double entry2 = squared(from.speed);
  const double peak2 =
      std::max({std::min(limits.speed2, a * length + 0.5 * (entry2 + exit2)), entry2, exit2});
  const double up = std::min(length, (peak2 - entry2) / (2.0 * a));
  const double down = std::min(length - up, (peak2 - exit2) / (2.0 * a));
  const double cruise = length - up - down;
  out.appendStretch(from, up, peak2);
  from.along += up;
  from.speed = std::sqrt(peak2);
  if (cruise > 0.0) out.appendStretch(from, cruise, peak2);
  from.along += std::max(0.0, cruise);
  out.appendStretch(from, down, exit2);
}

std::size_t SpeedPlan::cellAt(const MotionPlace& place) const {
  const auto later = std::upper_bound(
      cells_.begin() + 1, cells_.end(), place, [](const MotionPlace& p, const CurveCell& cell) {
        return p.span != cell.span ? p.span < cell.span : p.along < cell.start;
      });
  return static_cast<std::size_t>(later - cells_.begin() - 1);
}

void SpeedPlan::appendStop(Timeline& out, MotionPlace from) const {
  for (std::size_t i = cellAt(from); i < cells_.size() && from.speed > 0.0; ++i) {
    const CurveCell& cell = cells_[i];
    if (cell.span != from.span) from.along = 0.0;
    from.span = cell.span;
    const double length = cell.end - from.along;
    if (length <= 0.0) continue;
    const double entry2 = squared(from.speed);
    const double brake = limitsOf(i).braking(entry2);
    const double exit2 = std::min(entry2 - 2.0 * brake * length, entry2);
    if (exit2 <= 0.0) {
      out.appendStretch(from, std::min(length, entry2 / (2.0 * brake)), 0.0);
      return;
    }
    // The plan's own rest must not be overrun by rounding.
    const double bounded2 = std::min(exit2, speed2_[i + 1]);
    out.appendStretch(from, length, bounded2);
    from.along = cell.end;
    from.speed = std::sqrt(bounded2);
  }
}

void SpeedPlan::appendRestart(Timeline& out, MotionPlace from) const {
  from.speed = 0.0;
  std::size_t i = cellAt(from);
  double x = 0.0;
  while (i < cells_.size() && (from.along > cells_[i].start || x < speed2_[i])) {
    const double length = cells_[i].end - from.along;
    if (length > 0.0) {
      const double exit2 = std::min(speed2_[i + 1], limitsOf(i).reachable(x, length));
      appendCell(out, i, from, exit2);
      x = exit2;
    }
    ++i;
    from = i < cells_.size() ? MotionPlace{curve_, cells_[i].span, cells_[i].start, std::sqrt(x)}
                             : MotionPlace{curve_, cells_.back().span, cells_.back().end};
  }
  const auto& phases = timeline_.phases();
  const auto rest =
      std::lower_bound(phases.begin(), phases.end(), from, [&](const Phase& phase, const MotionPlace& place) {
        if (phase.span != place.span) return phase.span < place.span;
        return phase.along < place.along;
      });
  out.append(timeline_, static_cast<std::size_t>(rest - phases.begin()));
}

}  // namespace lamina
