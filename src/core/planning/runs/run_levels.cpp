// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/planning/runs/runs.hpp"
#include "planning/flow/path_cut.hpp"
#include "planning/runs/level_lead.hpp"
#include "planning/runs/level_rules.hpp"
#include "planning/runs/run_ends.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLevelSteps = 8;                           // of a rise or fall
constexpr double kCornerCosine = 0.70710678118654752440 - 1e-9;  // a turn of more than 45 deg
constexpr double kBoundSlack = 1e-9;                             // of a bound, for rounding

/// What is stated along all runs.
struct LevelStatement {
  std::vector<LevelChannel> channels;
  std::vector<LevelRule> rules;
  double wire_mm = 0.0;  ///< diameter
};

/// How a value rises and falls along a run.
class LevelRamp {
 public:
  /// @param start_hold_mm  way that the tip goes while the share at the start is held
  LevelRamp(const LevelChannel& channel, double start_hold_mm, double end_hold_mm, double run_mm)
      : start_(channel.start),
        end_(channel.end),
        start_hold_mm_(start_hold_mm),
        end_hold_mm_(end_hold_mm),
        run_mm_(run_mm) {}

  /// Ways from the run's start at which the value changes.
  std::vector<double> steps() const {
    std::vector<double> ways_mm;
    ways_mm.reserve(2 * kLevelSteps + 2);
    if (start_hold_mm_ > 0.0) ways_mm.push_back(start_hold_mm_);
    if (end_hold_mm_ > 0.0) ways_mm.push_back(run_mm_ - end_hold_mm_);
    for (std::size_t step = 1; step <= kLevelSteps; ++step) {
      const double share = static_cast<double>(step) / kLevelSteps;
      if (start_.over_mm > 0.0) ways_mm.push_back(start_hold_mm_ + share * start_.over_mm);
      if (end_.over_mm > 0.0) ways_mm.push_back(run_mm_ - end_hold_mm_ - share * end_.over_mm);
    }
    return ways_mm;
  }

  double shareAt(double way_mm) const {
    return rising(way_mm - start_hold_mm_, start_) * rising(run_mm_ - way_mm - end_hold_mm_, end_);
  }

 private:
  static double rising(double way_mm, const LevelEnd& end) {
    if (way_mm < 0.0) return end.share;
    return way_mm >= end.over_mm ? 1.0 : end.share + (1.0 - end.share) * way_mm / end.over_mm;
  }

  LevelEnd start_;
  LevelEnd end_;
  double start_hold_mm_;
  double end_hold_mm_;
  double run_mm_;
};

/// A motion of a run, in its order.
struct RunMotion {
  double begin_mm = 0.0;  ///< way from the run's start
  double length_mm = 0.0;
  double feed_mm_s = 0.0;
  Point3 direction = Point3::Zero();
};

std::vector<RunMotion> motionsOf(const Toolpath& toolpath, const std::vector<RunPlace>& places,
                                 const RunSpan& run) {
  std::vector<RunMotion> motions;
  double begin_mm = 0.0;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const Path& path = pathAt(toolpath, places[i]);
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      const Point3 way = path.points[end] - path.points[m];
      if (way.norm() == 0.0) continue;
      motions.push_back({begin_mm, way.norm(), path.feed_mm_s.at(end), way.normalized()});
      begin_mm += way.norm();
    }
  }
  return motions;
}

/// Ways from the run's start at which it turns by more than 45 deg.
/// @param is_ring  whether the run is one closed path, whose start may be a corner too
std::vector<double> cornersOf(const std::vector<RunMotion>& motions, bool is_ring) {
  std::vector<double> corners_mm;
  for (std::size_t i = is_ring ? 0 : 1; i < motions.size(); ++i) {
    const RunMotion& before = motions[(i + motions.size() - 1) % motions.size()];
    if (before.direction.dot(motions[i].direction) < kCornerCosine) corners_mm.push_back(motions[i].begin_mm);
  }
  return corners_mm;
}

/// Way that the tip goes in a time from one end of the run.
template <class Iterator>
double wayIn(double time_s, Iterator begin, Iterator end) {
  double way_mm = 0.0;
  for (; begin != end && time_s > 0.0; ++begin) {
    const double motion_s = begin->length_mm / begin->feed_mm_s;
    way_mm += std::min(time_s, motion_s) * begin->feed_mm_s;
    time_s -= motion_s;
  }
  return way_mm;
}

/// Values of all channels along the paths of one run.
class RunLevels {
 public:
  RunLevels(Toolpath& toolpath, const std::vector<RunPlace>& places, const RunSpan& run,
            const LevelStatement& statement)
      : toolpath_(toolpath), places_(places), run_(run), statement_(statement) {
    for (std::size_t i = run.begin; i < run.end; ++i) run_mm_ += length(pathAt(toolpath, places[i]));
    const std::vector<RunMotion> motions = motionsOf(toolpath, places, run);
    is_ring_ = run.count() == 1 && pathAt(toolpath, places[run.begin]).is_closed;
    for (const LevelRule& rule : statement.rules)
      if (rule.when.corner_mm > 0.0 && corners_mm_.empty()) corners_mm_ = cornersOf(motions, is_ring_);
    ramps_.reserve(statement.channels.size());
    for (const LevelChannel& channel : statement.channels)
      ramps_.emplace_back(channel, wayIn(channel.start.hold_s, motions.begin(), motions.end()),
                          wayIn(channel.end.hold_s, motions.rbegin(), motions.rend()), run_mm_);
  }

  void state() {
    const std::vector<double> ways_mm = steps();
    double begin_mm = 0.0;
    for (std::size_t i = run_.begin; i < run_.end; ++i) {
      const double length_mm = length(pathAt(toolpath_, places_[i]));
      stateAlong(places_[i], begin_mm, ways_mm);
      begin_mm += length_mm;
    }
  }

 private:
  /// Ways from the run's start at which any value may change.
  std::vector<double> steps() const {
    std::vector<double> ways_mm;
    for (const LevelRamp& ramp : ramps_) {
      const std::vector<double> steps = ramp.steps();
      ways_mm.insert(ways_mm.end(), steps.begin(), steps.end());
    }
    for (const LevelRule& rule : statement_.rules) {
      if (rule.when.corner_mm == 0.0) continue;
      for (const double corner_mm : corners_mm_)
        for (const double way_mm : {corner_mm - rule.when.corner_mm, corner_mm + rule.when.corner_mm}) {
          ways_mm.push_back(way_mm);
          if (is_ring_) ways_mm.push_back(way_mm < 0.0 ? way_mm + run_mm_ : way_mm - run_mm_);
        }
    }
    std::sort(ways_mm.begin(), ways_mm.end());
    return ways_mm;
  }

  void stateAlong(const RunPlace& place, double begin_mm, std::vector<double> ways_mm) {
    Path& path = pathAt(toolpath_, place);
    for (double& way_mm : ways_mm) way_mm -= begin_mm;
    path = withWaypoints(path, levelSteps(path, ways_mm));
    std::vector<double> middles_mm(path.points.size(), begin_mm);
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const double length_mm = motionLength(path, m);
      middles_mm[path.motionEnd(m)] = begin_mm + 0.5 * length_mm;
      begin_mm += length_mm;
    }
    for (std::size_t c = 0; c < ramps_.size(); ++c) {
      std::vector<double> values(path.points.size());
      for (std::size_t i = path.is_closed ? 0 : 1; i < values.size(); ++i)
        values[i] = valueAt(place, c, i, middles_mm[i]);
      if (!path.is_closed) values[0] = values[1];  // not used
      const bool is_common =
          std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); });
      path.values.push_back({statement_.channels[c].stated.name, is_common
                                                                     ? AlongPath<double>(values.front())
                                                                     : AlongPath<double>(std::move(values))});
    }
  }

  /// @param way_mm  from the run's start to the middle of the motion
  double valueAt(const RunPlace& place, std::size_t channel, std::size_t waypoint, double way_mm) const {
    const Path& path = pathAt(toolpath_, place);
    LevelPlace motion;
    motion.role = path.role;
    motion.layer = place.layer;
    motion.z_mm = toolpath_.layers[place.layer].z_mm;
    motion.corner_mm = cornerWay(way_mm);
    motion.feed_mm_s = path.feed_mm_s.at(waypoint);
    motion.bead = path.bead.at(waypoint);
    motion.wire_mm = statement_.wire_mm;
    RuledLevel level = ruledLevel(statement_.channels[channel], statement_.rules, motion);
    level.value = ramps_[channel].shareAt(way_mm) * level.value;
    requireWithin(statement_.channels[channel], level, place, waypoint);
    return level.value;
  }

  double cornerWay(double way_mm) const {
    double nearest_mm = std::numeric_limits<double>::infinity();
    for (const double corner_mm : corners_mm_) {
      const double apart_mm = std::abs(way_mm - corner_mm);
      nearest_mm = std::min({nearest_mm, apart_mm, is_ring_ ? run_mm_ - apart_mm : apart_mm});
    }
    return nearest_mm;
  }

  void requireWithin(const LevelChannel& channel, const RuledLevel& level, const RunPlace& place,
                     std::size_t waypoint) const {
    if (level.value >= channel.lower - kBoundSlack * channel.lower &&
        level.value <= channel.upper + kBoundSlack * channel.upper)
      return;
    const std::string unit = " " + unitOfLevel(channel.stated.name);
    const std::string& name = channel.stated.name;
    throw InvalidInput(placeText(toolpath_, place) + ", waypoint " + std::to_string(waypoint) + ": " + name +
                       " is " + numberText(level.value) + unit + " by " + level.by + "; expected " +
                       numberText(channel.lower) + unit +
                       (std::isinf(channel.upper) ? " or more" : " to " + numberText(channel.upper) + unit) +
                       ", as levels.channels." + name + " states");
  }

  Toolpath& toolpath_;
  const std::vector<RunPlace>& places_;
  RunSpan run_;
  const LevelStatement& statement_;
  double run_mm_ = 0.0;
  bool is_ring_ = false;
  std::vector<double> corners_mm_;
  std::vector<LevelRamp> ramps_;
};

}  // namespace

void stateLevels(Toolpath& toolpath, const LevelSettings& settings) {
  const LevelStatement statement{levelChannels(settings), levelRules(settings), settings.wire_diameter_mm};
  if (statement.channels.empty()) return;
  const std::vector<RunPlace> places = placesOf(toolpath);
  for (const RunSpan& run : beadRunsOf(toolpath, places)) RunLevels(toolpath, places, run, statement).state();
  leadLevels(toolpath, statement.channels);
}

}  // namespace lamina
