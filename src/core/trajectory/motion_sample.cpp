// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/motion_sample.hpp"

#include <algorithm>
#include <array>

namespace lamina {
namespace {

// Gauss-Legendre on [0, 1]: exact up to degree 9; joints on a rounding are of degree 8 in time.
constexpr std::array<double, 5> kNodes = {0.04691007703066800, 0.23076534494715845, 0.5, 0.76923465505284155,
                                          0.95308992296933200};
constexpr std::array<double, 5> kWeights = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                            0.23931433524968324, 0.11846344252809454};

bool isMoving(const JointStation& end) { return end.length_mm > 0.0; }

/// Adds what a way along a span asks of the levels that follow speed; those that nothing states stay
/// unstated.
void addAlong(const JointStation& end, double way_mm, ProcessLevels& sum) {
  for (const ProcessLevel level : kAllProcessLevels) {
    if (!followsSpeed(level) || !end.levels.has(level) || !isMoving(end)) continue;
    sum[level] = (sum.has(level) ? sum[level] : 0.0) + end.levels[level] * way_mm / end.feed_mm_s;
  }
}

/// The levels on the way to a station, those that follow speed unstated.
ProcessLevels heldLevels(const JointStation& end) {
  ProcessLevels levels = end.levels;
  for (const ProcessLevel level : kAllProcessLevels)
    if (followsSpeed(level)) levels[level] = ProcessLevels()[level];
  return levels;
}

JointState stateAt(const MotionPlace& place) {
  const CurvePoint point = place.curve->at(place.span, place.along);
  const JointStation& end = place.curve->spanEnd(place.span);
  JointState state;
  state.position = point.position;
  state.velocity = place.speed * point.tangent;
  state.acceleration = place.acceleration * point.tangent + place.speed * place.speed * point.bend;
  state.tip_speed_mm_s = isMoving(end) ? place.speed : 0.0;
  state.process.flow_mm3_s = end.area_mm2 * place.speed;
  state.process.levels = heldLevels(end);
  addAlong(end, place.speed, state.process.levels);
  state.heading_for = end.heading_for;
  return state;
}

/// Adds what a stretch of one phase contributes to integrals of position, way and volume.
void integrate(const Timeline& timeline, std::size_t index, double from_s, double to_s, JointState& sum) {
  const Phase& phase = timeline.phases()[index];
  const double duration_s = to_s - from_s;
  const auto alongAt = [&](double time_s) {
    return std::clamp(phase.alongAfter(time_s - phase.time_s), 0.0, phase.curve->length(phase.span));
  };
  for (std::size_t k = 0; k < kNodes.size(); ++k)
    sum.position += kWeights[k] * duration_s *
                    phase.curve->positionAt(phase.span, alongAt(from_s + kNodes[k] * duration_s));
  const JointStation& end = phase.curve->spanEnd(phase.span);
  if (!isMoving(end)) return;
  const double way = alongAt(to_s) - alongAt(from_s);
  sum.tip_speed_mm_s += way;
  sum.process.flow_mm3_s += end.area_mm2 * way;
  addAlong(end, way, sum.process.levels);
}

}  // namespace

JointState motionSample(const Timeline& timeline, double averaging_s, double time_s) {
  JointState now = stateAt(timeline.placeAt(time_s));
  now.time_s = time_s;
  if (averaging_s == 0.0) return now;
  const double from_s = time_s - averaging_s;
  const JointState then = stateAt(timeline.placeAt(from_s));
  JointState state = now;
  const double before_s = std::clamp(-from_s, 0.0, averaging_s);
  const double after_s = std::clamp(time_s - timeline.end(), 0.0, averaging_s);
  state.position = before_s * then.position + after_s * now.position;
  state.tip_speed_mm_s = state.process.flow_mm3_s = 0.0;
  const MotionPlace middle = timeline.placeAt(time_s - 0.5 * averaging_s);
  const JointStation& heading = middle.curve->spanEnd(middle.span);
  state.process.levels = heldLevels(heading);
  const double last_s = std::min(time_s, timeline.end());
  double at_s = std::max(from_s, 0.0);
  for (std::size_t i = timeline.phaseAt(at_s); at_s < last_s; ++i) {
    const double to_s = std::min(timeline.endOf(i), last_s);
    integrate(timeline, i, at_s, to_s, state);
    at_s = to_s;
  }
  state.position /= averaging_s;
  state.velocity = (now.position - then.position) / averaging_s;
  state.acceleration = (now.velocity - then.velocity) / averaging_s;
  state.tip_speed_mm_s /= averaging_s;
  state.process.flow_mm3_s /= averaging_s;
  for (const ProcessLevel level : kAllProcessLevels)
    if (followsSpeed(level)) state.process.levels[level] /= averaging_s;
  state.heading_for = heading.heading_for;
  return state;
}

}  // namespace lamina
