// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/timing.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "toolpath/layer_time.hpp"
#include "toolpath/motion_cursor.hpp"

namespace lamina {
namespace {

/// Motions of a toolpath, each with its speed profile.
class TimedMotions {
 public:
  TimedMotions(const Toolpath& toolpath, const MotionLimits& limits)
      : limits_(limits), ahead_(toolpath), motion_(toolpath), planner_(limits.junction_deviation_mm) {}

  /// Steps to the next motion; false after the last.
  bool step() {
    std::optional<SpeedProfile> next = planner_.next();
    while (!next && !is_planned_) {
      is_planned_ = !ahead_.step();
      // The nozzle rests where it waits.
      if (is_planned_ || ahead_.dwell() > 0.0) planner_.finish();
      if (!is_planned_) {
        planner_.add(ahead_.segment(limits_));
        planned_.push_back(ahead_);
      }
      next = planner_.next();
    }
    if (!next) return false;
    profile_ = *next;
    motion_ = planned_.front();
    planned_.pop_front();
    return true;
  }

  const MotionCursor& motion() const { return motion_; }
  const SpeedProfile& profile() const { return profile_; }
  /// Waiting behind the last motion [s], once there is none left.
  double lastDwell() const { return ahead_.dwell(); }

 private:
  MotionLimits limits_;
  MotionCursor ahead_;
  MotionCursor motion_;
  std::deque<MotionCursor> planned_;  ///< at motions whose profiles are to come
  MotionPlanner planner_;
  SpeedProfile profile_;
  bool is_planned_ = false;
};

/// Calls visit(layer, dwell_s, duration_s) for each motion: no more of it is kept than that.
/// @return waiting behind the last motion [s]
template <class Visit>
double forEachDuration(MotionCursor motion, const MotionLimits& limits, const Visit& visit) {
  MotionPlanner planner(limits.junction_deviation_mm);
  std::deque<std::pair<std::size_t, double>> planned;  // layers and waiting of motions to be timed
  const auto take = [&] {
    while (const std::optional<SpeedProfile> profile = planner.next()) {
      visit(planned.front().first, planned.front().second, profile->duration_s);
      planned.pop_front();
    }
  };
  while (motion.step()) {
    if (motion.dwell() > 0.0) planner.finish();
    planner.add(motion.segment(limits));
    planned.emplace_back(motion.endWaypoint().layer, motion.dwell());
    take();
  }
  planner.finish();
  take();
  return motion.dwell();
}

double dwellAtEnd(const Toolpath& toolpath) {
  double sum_s = 0.0;
  for (const ToolpathEvent& event : toolpath.events_at_end)
    if (const auto* const dwell = std::get_if<Dwell>(&event)) sum_s += dwell->duration_s;
  return sum_s;
}

}  // namespace

double nominalTime(const Toolpath& toolpath) {
  double sum_s = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const std::size_t end = path.motionEnd(m);
        const double feed_mm_s = path.feed_mm_s.at(end);
        if (!(feed_mm_s > 0.0))
          throw InvalidInput("a feed is " + numberText(feed_mm_s) + " mm/s; must be positive");
        sum_s += (path.points[end] - path.points[m]).norm() / feed_mm_s;
      }
  return sum_s;
}

ToolpathTime estimateTime(const Toolpath& toolpath, const MotionLimits& limits) {
  ToolpathTime time;
  time.layer_start_s.reserve(toolpath.layers.size());
  const auto add = [&time](std::size_t layer, double dwell_s, double duration_s) {
    time.total_s += dwell_s;
    if (time.layer_start_s.size() <= layer) time.layer_start_s.resize(layer + 1, time.total_s);
    time.total_s += duration_s;
  };
  const double waiting_s = forEachDuration(MotionCursor(toolpath), limits, add);
  time.total_s += waiting_s + dwellAtEnd(toolpath);
  time.layer_start_s.resize(toolpath.layers.size(), time.total_s);
  return time;
}

double layerTime(const ToolpathLayer& layer, const MotionLimits& limits) {
  double sum_s = 0.0;
  const auto add = [&sum_s](std::size_t, double dwell_s, double duration_s) {
    sum_s += dwell_s;
    sum_s += duration_s;
  };
  const double waiting_s = forEachDuration(MotionCursor(&layer, 1), limits, add);
  return sum_s + waiting_s;
}

PathTimes estimatePathTimes(const Toolpath& toolpath, const MotionLimits& limits) {
  PathTimes times;
  times.start_s.resize(toolpath.layers.size());
  std::size_t layer = 0;
  // Paths that go nowhere begin with the next one that does.
  const auto beginUpTo = [&](std::size_t at_layer, std::size_t path) {
    for (; layer < at_layer; ++layer)
      times.start_s[layer].resize(toolpath.layers[layer].paths.size(), times.total_s);
    if (layer < times.start_s.size() && times.start_s[layer].size() < path)
      times.start_s[layer].resize(path, times.total_s);
  };
  TimedMotions motions(toolpath, limits);
  while (motions.step()) {
    const WaypointIndex end = motions.motion().endWaypoint();
    beginUpTo(end.layer, end.path + 1);
    times.total_s += motions.motion().dwell() + motions.profile().duration_s;
  }
  times.total_s += motions.lastDwell() + dwellAtEnd(toolpath);
  beginUpTo(times.start_s.size(), 0);
  return times;
}

class ToolpathPlayer::State {
 public:
  State(const Toolpath& toolpath, const MotionLimits& limits)
      : toolpath_(toolpath), limits_(limits), motions_(toolpath, limits) {}

  NozzleSample at(double time_s) {
    if (!is_started_ || time_s < wait_s_) rewind();
    while (!is_finished_ && time_s >= start_s_ + motions_.profile().duration_s) {
      const double end_s = start_s_ + motions_.profile().duration_s;
      is_finished_ = !motions_.step();
      if (!is_finished_) beginAt(end_s);
    }
    return sample(time_s);
  }
  double nextWaypointTime() const {
    if (!is_started_ || is_finished_) return std::numeric_limits<double>::infinity();
    return start_s_ + motions_.profile().duration_s;
  }
  bool isFinished() const { return is_finished_; }

 private:
  void rewind() {
    motions_ = TimedMotions(toolpath_, limits_);
    is_finished_ = false;
    is_started_ = motions_.step();
    if (!is_started_)
      throw InvalidInput("the toolpath of '" + toolpath_.part_name + "' has no motion to play");
    beginAt(0.0);
  }

  /// The motion it stands at begins, after its waiting.
  void beginAt(double time_s) {
    wait_s_ = time_s;
    start_s_ = time_s + motions_.motion().dwell();
  }

  NozzleSample sample(double time_s) const {
    const MotionCursor& motion = motions_.motion();
    const SpeedProfile& profile = motions_.profile();
    const double local_s = is_finished_ ? profile.duration_s : time_s - start_s_;
    const double fraction = profile.distanceAt(local_s) / profile.length_mm;
    const auto& orientation = motion.path().orientation;
    NozzleSample sample;
    sample.time_s = time_s;
    sample.heading_for = motion.endWaypoint();
    sample.position = motion.start() + fraction * (motion.end() - motion.start());
    sample.orientation = orientation.isCommon()
                             ? orientation.at(0)
                             : orientation.at(motion.startWaypoint())
                                   .slerp(fraction, orientation.at(sample.heading_for.waypoint));
    sample.speed_mm_s = profile.speedAt(local_s);
    return sample;
  }

  const Toolpath& toolpath_;
  MotionLimits limits_;
  TimedMotions motions_;
  double wait_s_ = 0.0;   ///< when the waiting before the motion begins
  double start_s_ = 0.0;  ///< when the motion begins
  bool is_started_ = false;
  bool is_finished_ = false;
};

ToolpathPlayer::ToolpathPlayer(const Toolpath& toolpath, const MotionLimits& limits)
    : state_(std::make_unique<State>(toolpath, limits)) {}
ToolpathPlayer::~ToolpathPlayer() = default;
ToolpathPlayer::ToolpathPlayer(ToolpathPlayer&&) noexcept = default;
ToolpathPlayer& ToolpathPlayer::operator=(ToolpathPlayer&&) noexcept = default;

NozzleSample ToolpathPlayer::at(double time_s) { return state_->at(time_s); }
double ToolpathPlayer::nextWaypointTime() const { return state_->nextWaypointTime(); }
bool ToolpathPlayer::isFinished() const { return state_->isFinished(); }

}  // namespace lamina
