// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/speed_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trajectory/smooth_rise.hpp"

namespace lamina {
namespace {

constexpr int kPartsOfHalf = 4;         // of a rounding, on either side of its station
constexpr double kShortestPart = 1e-9;  // of a span, that is worth a cell
constexpr double kFaster = 1e-12;       // of a squared speed, that is no rounding of numbers

/// The speed at which to run a rounding so that averaging takes tip or tool axis no further off than the
/// tolerance.
double averagedSpeed2(double tolerance, double turned, double averaging_s) {
  return turned > 0.0 ? 24.0 * tolerance / (averaging_s * averaging_s * turned)
                      : std::numeric_limits<double>::infinity();
}

void limitInRounding(CellLimits& limits, const JointCurve& curve, const CurveCell& cell, double averaging_s) {
  const bool is_at_start = cell.part < 0;
  const std::size_t corner = is_at_start ? cell.span : cell.span + 1;
  const double b = curve.blend(corner);
  // Parts are numbered from the station outwards.
  const double near = 0.5 * (std::abs(cell.part) - 1) / kPartsOfHalf;
  const double far = 0.5 * std::abs(cell.part) / kPartsOfHalf;
  const double u0 = is_at_start ? 0.5 + near : 0.5 - near;
  const double u1 = is_at_start ? 0.5 + far : 0.5 - far;
  const JointValues before = curve.tangent(corner - 1);
  const JointValues turned = curve.turn(corner);
  const double steepest = smoothRiseRate(u0) / (2.0 * b);  // the bend grows towards the station
  limits.tangent =
      (before + smoothRise(u0) * turned).cwiseAbs().cwiseMax((before + smoothRise(u1) * turned).cwiseAbs());
  limits.bend = steepest * turned.cwiseAbs();
  const double tip_bend = steepest * curve.tipTurn(corner);
  if (curve.spanEnd(cell.span).length_mm > 0.0 && tip_bend > 0.0)
    limits.speed2 = std::min(limits.speed2, limits.path_acceleration / tip_bend);
  if (averaging_s == 0.0) return;
  limits.speed2 = std::min(
      {limits.speed2, averagedSpeed2(curve.tipTolerance(corner), tip_bend, averaging_s),
       averagedSpeed2(curve.toolAxisTolerance(corner), steepest * curve.toolAxisTurn(corner), averaging_s)});
}

double squared(double value) { return value * value; }

/// All cells of a curve in order, of positive length each.
std::vector<CurveCell> curveCells(const JointCurve& curve) {
  std::vector<CurveCell> cells;
  cells.reserve(curve.spanCount() * (2 * kPartsOfHalf + 1));
  for (std::uint32_t span = 0; span < curve.spanCount(); ++span) {
    const double length = curve.length(span);
    const double b_start = curve.blend(span);
    const double b_end = curve.blend(span + 1);
    const auto partOf = [](double b, int part) { return b * part / kPartsOfHalf; };
    for (int part = 1; part <= kPartsOfHalf && b_start > 0.0; ++part)
      cells.push_back(
          {partOf(b_start, part - 1), partOf(b_start, part), span, static_cast<std::int8_t>(-part)});
    if (length - b_start - b_end > kShortestPart * length)
      cells.push_back({b_start, length - b_end, span, 0});
    for (int part = kPartsOfHalf; part > 0 && b_end > 0.0; --part)
      cells.push_back({length - partOf(b_end, part), length - partOf(b_end, part - 1), span,
                       static_cast<std::int8_t>(part)});
  }
  return cells;
}

}  // namespace

CellLimits cellLimits(const JointCurve& curve, const CurveCell& cell, const SpeedsAsked& asked) {
  const JointStation& end = curve.spanEnd(cell.span);
  CellLimits limits;
  limits.acceleration = curve.maxAcceleration();
  limits.path_acceleration = end.acceleration_mm_s2;
  limits.speed2 = squared(asked.feed_share * end.feed_mm_s);
  if (cell.part == 0) {
    limits.tangent = curve.tangent(cell.span).cwiseAbs();
    limits.bend = JointValues::Zero(limits.tangent.size());
  } else {
    limitInRounding(limits, curve, cell, asked.averaging_s);
  }
  for (Eigen::Index j = 0; j < limits.tangent.size(); ++j) {
    const double speed = curve.maxSpeed()[j];
    const double tangent = limits.tangent[j];
    if (tangent > 0.0) limits.speed2 = std::min(limits.speed2, speed * speed / (tangent * tangent));
    if (limits.bend[j] > 0.0)
      limits.speed2 = std::min(limits.speed2, limits.acceleration[j] / limits.bend[j]);
  }
  return limits;
}

double CellLimits::reachable(double x, double length) const {
  double most = x + 2.0 * length * path_acceleration;
  for (Eigen::Index j = 0; j < tangent.size(); ++j) {
    const double per = 2.0 * length * bend[j] + tangent[j];
    if (per > 0.0) most = std::min(most, (2.0 * length * acceleration[j] + tangent[j] * x) / per);
  }
  return most;
}

double CellLimits::braking(double x) const {
  double most = path_acceleration;
  for (Eigen::Index j = 0; j < tangent.size(); ++j)
    if (tangent[j] > 0.0) most = std::min(most, (acceleration[j] - bend[j] * x) / tangent[j]);
  return std::max(0.0, most);
}

SpeedPlan::SpeedPlan(const JointCurve& curve, const Waits& waits, double feed_share)
    : curve_(&curve), asked_{waits.averaging_s, feed_share}, cells_(curveCells(curve)) {
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
  double wait_s = waits.averaging_s + curve_->dwell(station);
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
    appendCell(timeline_, i, {curve_, cell.span, cell.start, std::sqrt(speed2_[i])}, speed2_[i + 1], 1.0);
  }
  if (cells_.empty()) return;
  const std::uint32_t last = cells_.back().span;
  appendWait(last, curve_->length(last), last + 1);
}

/// From a place in a cell to its end. In a rounding the squared speed is linear; on the straight part the
/// fastest profile is run, after it has braked to the share of the greatest speed.
void SpeedPlan::appendCell(Timeline& out, std::size_t cell, MotionPlace from, double exit2,
                           double share) const {
  double length = cells_[cell].end - from.along;
  if (cells_[cell].part != 0) return out.appendStretch(from, length, exit2);
  const CellLimits limits = limitsOf(cell);
  const double a = limits.braking(0.0);
  const double fastest2 = squared(share) * limits.speed2;
  double entry2 = squared(from.speed);
  if (entry2 > (1.0 + kFaster) * fastest2 && exit2 <= fastest2) {
    const double slowing = std::min(length, (entry2 - fastest2) / (2.0 * a));
    entry2 = std::max(fastest2, entry2 - 2.0 * a * slowing);
    out.appendStretch(from, slowing, entry2);
    from.along += slowing;
    from.speed = std::sqrt(entry2);
    length -= slowing;
  }
  const double peak2 = std::max({std::min(fastest2, a * length + 0.5 * (entry2 + exit2)), entry2, exit2});
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

void SpeedPlan::appendFrom(Timeline& out, MotionPlace from, const SharedSpeeds& speeds,
                           RestThere rest) const {
  const std::size_t first = cellAt(from);
  std::size_t i = first;
  double x = squared(from.speed);
  const auto planned = [&](std::size_t node) { return squared(speeds.share) * speeds.plan.speed2_[node]; };
  while (i < cells_.size() && (from.along > cells_[i].start || x != planned(i))) {
    const double length = cells_[i].end - from.along;
    if (length > 0.0) {
      const CellLimits limits = limitsOf(i);
      const double slowest = std::min(speed2_[i + 1], x - 2.0 * limits.braking(x) * length);
      const double exit2 = std::min(std::max(planned(i + 1), slowest), limits.reachable(x, length));
      speeds.plan.appendCell(out, i, from, exit2, speeds.share);
      x = exit2;
    }
    ++i;
    from = i < cells_.size() ? MotionPlace{curve_, cells_[i].span, cells_[i].start, std::sqrt(x)}
                             : MotionPlace{curve_, cells_.back().span, cells_.back().end};
  }
  const auto& phases = speeds.plan.timeline_.phases();
  auto next =
      std::lower_bound(phases.begin(), phases.end(), from, [&](const Phase& phase, const MotionPlace& place) {
        if (phase.span != place.span) return phase.span < place.span;
        return phase.along < place.along;
      });
  if (rest == RestThere::Over && i == first)
    next = std::find_if(next, phases.end(), [](const Phase& phase) { return phase.kind == PhaseKind::Move; });
  out.append(speeds.plan.timeline_, static_cast<std::size_t>(next - phases.begin()), speeds.share);
}

}  // namespace lamina
