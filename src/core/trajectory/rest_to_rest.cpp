// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/rest_to_rest.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "toolpath/motion_cursor.hpp"

namespace lamina {
namespace {

void requirePositive(double value, const char* what, const char* unit) {
  if (!(value > 0.0 && std::isfinite(value)))
    throw InvalidInput(std::string(what) + " of a motion from rest to rest is " + numberText(value) + " " +
                       unit + "; must be positive");
}

double timeOf(const MotionSegment& segment) {
  return restToRestTime(segment.length_mm, segment.feed_mm_s, segment.acceleration_mm_s2);
}

}  // namespace

double restToRestTime(double length_mm, double speed_mm_s, double acceleration_mm_s2) {
  requirePositive(speed_mm_s, "speed", "mm/s");
  requirePositive(acceleration_mm_s2, "acceleration", "mm/s2");
  if (!(length_mm >= 0.0 && std::isfinite(length_mm)))
    throw InvalidInput("length of a motion from rest to rest is " + numberText(length_mm) +
                       " mm; must be 0 or more");
  const double ramp_s = speed_mm_s / acceleration_mm_s2;
  const double cruise_s = length_mm / speed_mm_s;
  return cruise_s > ramp_s ? cruise_s + ramp_s : std::sqrt(4.0 * length_mm / acceleration_mm_s2);
}

ToolpathTime restToRestTime(const Toolpath& toolpath, const MotionLimits& limits) {
  ToolpathTime time;
  MotionCursor cursor(toolpath);
  while (cursor.step()) {
    const std::size_t layer = cursor.endWaypoint().layer;
    time.total_s += cursor.dwell();
    if (time.layer_start_s.size() <= layer) time.layer_start_s.resize(layer + 1, time.total_s);
    time.total_s += timeOf(cursor.segment(limits));
  }
  time.total_s += cursor.dwell();
  time.layer_start_s.resize(toolpath.layers.size(), time.total_s);
  return time;
}

RestToRestPlayer::RestToRestPlayer(const Toolpath& toolpath, const MotionLimits& limits) : start_s_(1, 0.0) {
  MotionCursor cursor(toolpath);
  while (cursor.step()) {
    start_s_.back() += cursor.dwell();
    motions_.push_back({cursor.start(), cursor.segment(limits), cursor.endWaypoint()});
    start_s_.push_back(start_s_.back() + timeOf(motions_.back().segment));
  }
  if (motions_.empty())
    throw InvalidInput("the toolpath of '" + toolpath.part_name + "' has no motion to play");
}

RestToRestSample RestToRestPlayer::at(double time_s) const {
  const auto after = std::upper_bound(start_s_.begin() + 1, start_s_.end() - 1, time_s);
  const auto index = static_cast<std::size_t>(after - start_s_.begin() - 1);
  const Motion& motion = motions_[index];
  const SpeedProfile profile = speedProfile(motion.segment, 0.0, 0.0);
  const double local_s = std::clamp(time_s - start_s_[index], 0.0, profile.duration_s);
  const double ramp_s = profile.cruise_mm_s / profile.acceleration_mm_s2;
  const bool is_moving = time_s >= 0.0 && time_s < duration();
  RestToRestSample sample;
  sample.time_s = time_s;
  sample.heading_for = motion.end;
  sample.position = motion.start + profile.distanceAt(local_s) * motion.segment.direction;
  sample.velocity = profile.speedAt(local_s) * motion.segment.direction;
  if (is_moving && local_s < ramp_s)
    sample.acceleration = profile.acceleration_mm_s2 * motion.segment.direction;
  else if (is_moving && local_s > profile.duration_s - ramp_s)
    sample.acceleration = -profile.acceleration_mm_s2 * motion.segment.direction;
  return sample;
}

std::vector<RestToRestSample> RestToRestPlayer::sampled(double step_s) const {
  requirePositive(step_s, "sampling step", "s");
  std::vector<RestToRestSample> samples;
  for (std::size_t i = 0; static_cast<double>(i) * step_s < duration(); ++i)
    samples.push_back(at(static_cast<double>(i) * step_s));
  samples.push_back(at(duration()));
  return samples;
}

}  // namespace lamina
