// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "lamina/planning/flow/flow.hpp"
#include "lamina/toolpath/motion_planner.hpp"
#include "planning/flow/path_cut.hpp"
#include "toolpath/deposited_segment.hpp"
#include "toolpath/motion_cursor.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

/// The flow that is to leave the nozzle along one run, over the time from its start. It is piecewise linear,
/// may jump between pieces, and is 0 before and after the run.
class DesiredFlow {
 public:
  /// Appends a motion that lays a bead of that section [mm²].
  void add(const SpeedProfile& profile, double section_mm2);

  double duration() const { return stretches_.empty() ? 0.0 : stretches_.back().end_s; }
  /// The flow at a time [mm³/s]; that before a jump at it.
  double flowBefore(double time_s) const;
  /// The volume up to a time [mm³].
  double volumeUntil(double time_s) const;
  /// Times strictly between two times at which the slope may change, ascending.
  std::vector<double> changesBetween(double from_s, double to_s) const;

 private:
  struct Stretch {
    double start_s;
    double end_s;
    double from_mm3_s;
    double to_mm3_s;
    double volume_before_mm3;

    double flowAt(double time_s) const;
    double volume(double until_s) const;
  };

  void addStretch(double duration_s, double from_mm3_s, double to_mm3_s);
  /// The stretch that ends at or after that time, if there is one.
  std::vector<Stretch>::const_iterator stretchAt(double time_s) const;

  std::vector<Stretch> stretches_;
};

constexpr double kInstant = 1e-9;  // s

double DesiredFlow::Stretch::flowAt(double time_s) const {
  const double share = (time_s - start_s) / (end_s - start_s);
  return from_mm3_s + share * (to_mm3_s - from_mm3_s);
}

double DesiredFlow::Stretch::volume(double until_s) const {
  return 0.5 * (from_mm3_s + flowAt(until_s)) * (until_s - start_s);
}

void DesiredFlow::add(const SpeedProfile& profile, double section_mm2) {
  const double faster_s = (profile.cruise_mm_s - profile.entry_mm_s) / profile.acceleration_mm_s2;
  const double slower_s = (profile.cruise_mm_s - profile.exit_mm_s) / profile.acceleration_mm_s2;
  const double cruise = section_mm2 * profile.cruise_mm_s;
  addStretch(faster_s, section_mm2 * profile.entry_mm_s, cruise);
  addStretch(profile.duration_s - faster_s - slower_s, cruise, cruise);
  addStretch(slower_s, cruise, section_mm2 * profile.exit_mm_s);
}

void DesiredFlow::addStretch(double duration_s, double from_mm3_s, double to_mm3_s) {
  if (duration_s < kInstant) return;
  const double start_s = duration();
  const double before = volumeUntil(start_s);
  stretches_.push_back({start_s, start_s + duration_s, from_mm3_s, to_mm3_s, before});
}

std::vector<DesiredFlow::Stretch>::const_iterator DesiredFlow::stretchAt(double time_s) const {
  return std::lower_bound(stretches_.begin(), stretches_.end(), time_s - kInstant,
                          [](const Stretch& stretch, double time) { return stretch.end_s < time; });
}

double DesiredFlow::flowBefore(double time_s) const {
  const auto stretch = stretchAt(time_s);
  return time_s < kInstant || stretch == stretches_.end() ? 0.0
                                                          : stretch->flowAt(std::min(time_s, stretch->end_s));
}

double DesiredFlow::volumeUntil(double time_s) const {
  if (stretches_.empty() || time_s <= 0.0) return 0.0;
  const auto stretch = stretchAt(time_s);
  const Stretch& last = stretch == stretches_.end() ? stretches_.back() : *stretch;
  return last.volume_before_mm3 + last.volume(std::min(time_s, last.end_s));
}

std::vector<double> DesiredFlow::changesBetween(double from_s, double to_s) const {
  std::vector<double> changes;
  for (auto stretch = stretchAt(from_s); stretch != stretches_.end() && stretch->end_s < to_s - kInstant;
       ++stretch)
    if (stretch->end_s > from_s + kInstant) changes.push_back(stretch->end_s);
  return changes;
}

constexpr double kPartsOfLag = 50.0;      // so finely a change is followed
constexpr double kShortestTime = 0.5e-3;  // s; the shortest piece
constexpr double kSameTime = 1e-9;        // s; changes of one time
constexpr double kShortestWay = 0.02;     // mm; the same
constexpr double kPastShortest = 1.01;    // of the shortest way: what is not too short
constexpr double kSteady = 1e-6;          // of a flow: what does not change

/// A motion, and how it is run.
struct TimedMotion {
  std::size_t layer = 0;
  std::size_t path = 0;
  std::size_t motion = 0;
  bool goes_on = false;  ///< the run of the motion before
  SpeedProfile profile;
};

/// Those that deposit beads.
std::vector<TimedMotion> timedRuns(const Toolpath& toolpath, const MotionLimits& limits) {
  std::vector<TimedMotion> motions;
  std::vector<bool> deposits;
  MotionPlanner planner(limits.junction_deviation_mm);
  MotionCursor cursor(toolpath);
  while (cursor.step()) {
    const bool waits = cursor.dwell() > 0.0;
    if (waits) planner.finish();
    planner.add(cursor.segment(limits));
    const bool goes_on = !waits && !deposits.empty() && deposits.back();
    const WaypointIndex end = cursor.endWaypoint();
    deposits.push_back(laysBeads(cursor.path()));
    motions.push_back({end.layer, end.path, cursor.startWaypoint(), goes_on, {}});
  }
  planner.finish();
  for (TimedMotion& motion : motions) motion.profile = *planner.next();
  std::vector<TimedMotion> runs;
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (deposits[i]) runs.push_back(motions[i]);
  return runs;
}

/// A piece of a motion: where it ends, and the section of what is pushed along it.
struct PushedPiece {
  double until_mm = 0.0;
  double section_mm2 = 0.0;
};

/// Pieces of each motion of a path; none of a motion that stays.
using PushedPath = std::vector<std::vector<PushedPiece>>;

class RunPusher {
 public:
  RunPusher(const Toolpath& toolpath, const FlowSettings& settings, double flow_factor)
      : toolpath_(toolpath),
        lag_s_(settings.lag_s),
        dead_s_(settings.dead_time_s),
        step_s_(std::max(kShortestTime, (lag_s_ + dead_s_) / kPartsOfLag)),
        greatest_mm3_s_(settings.greatest_mm3_s > 0.0 ? settings.greatest_mm3_s / flow_factor
                                                      : std::numeric_limits<double>::infinity()) {}

  /// The pieces of each of the run's motions.
  std::vector<std::vector<PushedPiece>> pieces(const TimedMotion* first, const TimedMotion* last) {
    DesiredFlow desired;
    for (const TimedMotion* motion = first; motion != last; ++motion)
      desired.add(motion->profile, sectionOf(*motion));
    std::vector<std::vector<PushedPiece>> pieces;
    double start_s = 0.0;
    for (const TimedMotion* motion = first; motion != last; ++motion) {
      pieces.push_back(piecesOf(*motion, start_s, desired));
      start_s += motion->profile.duration_s;
    }
    ++unmet_.runs;
    unmet_.unmet_mm3 += desired.volumeUntil(dead_s_);
    return pieces;
  }

  const FeedForward& unmet() const { return unmet_; }

 private:
  double sectionOf(const TimedMotion& motion) const {
    const Path& path = toolpath_.layers[motion.layer].paths[motion.path];
    return crossSection(path.bead.at(path.motionEnd(motion.motion)));
  }

  /// When the flow that is due, or the speed, may change, from the motion's start to its end.
  std::vector<double> changes(const TimedMotion& motion, double start_s, const DesiredFlow& desired) const {
    const double end_s = start_s + motion.profile.duration_s;
    std::vector<double> changes_s = {0.0};
    for (const double shift_s : {0.0, dead_s_})
      for (const double change_s : desired.changesBetween(start_s + shift_s, end_s + shift_s))
        changes_s.push_back(change_s - shift_s - start_s);
    std::sort(changes_s.begin(), changes_s.end());
    const auto is_same = [](double earlier, double later) { return later - earlier < kSameTime; };
    changes_s.erase(std::unique(changes_s.begin(), changes_s.end(), is_same), changes_s.end());
    changes_s.push_back(motion.profile.duration_s);
    return changes_s;
  }

  /// When pieces of a motion end, from its start.
  std::vector<double> ends(const TimedMotion& motion, double start_s, const DesiredFlow& desired) const {
    const std::vector<Stretch> stretches = stretchesOf(motion, start_s, desired);
    std::vector<double> ends_s;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const Stretch& stretch = stretches[i];
      if (!stretch.slopes) {
        // A jump, and a slope too short for a piece of its own, is made up for in one short piece beside it:
        // along all that is steady, it would be deposited as a bead too thick, or too thin.
        const double short_s = std::max(kShortestTime, kPastShortest * kShortestWay / stretch.speed_mm_s);
        const bool follows_change = stretch.jumps || (i > 0 && isLost(stretches[i - 1]));
        const bool precedes_change = i + 1 < stretches.size() && isLost(stretches[i + 1]);
        if (follows_change && short_s < stretch.duration()) ends_s.push_back(stretch.from_s + short_s);
        if (precedes_change && 2.0 * short_s < stretch.duration()) ends_s.push_back(stretch.to_s - short_s);
        ends_s.push_back(stretch.to_s);
        continue;
      }
      const int steps = static_cast<int>(std::ceil(stretch.duration() / step_s_));
      for (int step = 1; step <= steps; ++step)
        ends_s.push_back(stretch.from_s + stretch.duration() * step / steps);
    }
    return ends_s;
  }

  /// What lies between two changes of a motion, times from its start.
  struct Stretch {
    double from_s = 0.0;
    double to_s = 0.0;
    double way_mm = 0.0;
    double speed_mm_s = 0.0;  ///< of the nozzle, early in it
    bool slopes = false;      ///< flow due or speed change along it
    bool jumps = false;       ///< the flow due jumps as it begins

    double duration() const { return to_s - from_s; }
  };

  static bool isLost(const Stretch& stretch) { return stretch.slopes && stretch.way_mm < kShortestWay; }

  std::vector<Stretch> stretchesOf(const TimedMotion& motion, double start_s,
                                   const DesiredFlow& desired) const {
    const std::vector<double> changes_s = changes(motion, start_s, desired);
    const SpeedProfile& profile = motion.profile;
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i + 1 < changes_s.size(); ++i) {
      const double from_s = changes_s[i];
      const double to_s = changes_s[i + 1];
      const double early_s = std::min(from_s + step_s_, 0.5 * (from_s + to_s));
      const auto due = [&](double time_s) { return desired.flowBefore(start_s + time_s + dead_s_); };
      Stretch stretch = {from_s, to_s, profile.distanceAt(to_s) - profile.distanceAt(from_s),
                         profile.speedAt(early_s)};
      stretch.slopes =
          differ(due(early_s), due(to_s)) || differ(profile.speedAt(early_s), profile.speedAt(to_s));
      stretch.jumps = start_s + from_s == 0.0 || differ(due(from_s), due(early_s));
      stretches.push_back(stretch);
    }
    return stretches;
  }

  static bool differ(double one, double other) {
    return std::abs(one - other) > kSteady * std::max(one, other);
  }

  std::vector<PushedPiece> piecesOf(const TimedMotion& motion, double start_s, const DesiredFlow& desired) {
    std::vector<PushedPiece> pieces;
    double from_s = 0.0;
    double from_mm = 0.0;
    const std::vector<double> ends_s = ends(motion, start_s, desired);
    for (std::size_t i = 0; i < ends_s.size(); ++i) {
      const double to_mm = motion.profile.distanceAt(ends_s[i]);
      const bool is_short = to_mm - from_mm < kShortestWay || motion.profile.length_mm - to_mm < kShortestWay;
      if (is_short && i + 1 < ends_s.size()) continue;
      const double whole_mm3 = pushed(start_s + from_s, start_s + ends_s[i], desired);
      const double most_mm3 = greatest_mm3_s_ * (ends_s[i] - from_s);
      const double pushed_mm3 = std::clamp(whole_mm3, 0.0, most_mm3);
      if (std::abs(whole_mm3 - pushed_mm3) > kSteady * std::abs(whole_mm3)) {
        unmet_.unmet_mm3 += std::abs(whole_mm3 - pushed_mm3);
        unmet_.unmet_mm += to_mm - from_mm;
      }
      if (to_mm > from_mm) pieces.push_back({to_mm, pushed_mm3 / (to_mm - from_mm)});
      from_s = ends_s[i];
      from_mm = to_mm;
    }
    return pieces;
  }

  /// Between two times of the run [mm³]. What is to be in store by the time that anything arrives is pushed
  /// as it starts; what was to arrive until then cannot be.
  double pushed(double from_s, double to_s, const DesiredFlow& desired) const {
    const double stored_before = from_s > 0.0 ? lag_s_ * desired.flowBefore(from_s + dead_s_) : 0.0;
    const double deposited = desired.volumeUntil(to_s + dead_s_) - desired.volumeUntil(from_s + dead_s_);
    return deposited + lag_s_ * desired.flowBefore(to_s + dead_s_) - stored_before;
  }

  const Toolpath& toolpath_;
  double lag_s_;
  double dead_s_;
  double step_s_;
  double greatest_mm3_s_;
  FeedForward unmet_;
};

Path pushedPath(const Path& path, const PushedPath& pieces) {
  std::vector<CutPlace> places;
  for (std::size_t m = 0; m < pieces.size(); ++m)
    for (std::size_t k = 0; k + 1 < pieces[m].size(); ++k)
      places.push_back({m, pieces[m][k].until_mm / motionLength(path, m)});
  Path made = withWaypoints(path, places);
  std::vector<Bead> beads(made.points.size(), path.bead.at(0));
  std::size_t motion = 0;
  for (std::size_t m = 0; m < pieces.size(); ++m) {
    const Bead& planned = path.bead.at(path.motionEnd(m));
    if (pieces[m].empty()) beads[made.motionEnd(motion++)] = planned;
    for (const PushedPiece& piece : pieces[m])
      beads[made.motionEnd(motion++)] = beadOfArea(piece.section_mm2, planned.height_mm);
  }
  made.bead = AlongPath<Bead>(std::move(beads));
  return made;
}

}  // namespace

FeedForward feedForward(Toolpath& toolpath, const FlowSettings& settings, const MotionLimits& limits,
                        double flow_factor) {
  if (settings.lag_s == 0.0 && settings.dead_time_s == 0.0) return {};
  const std::vector<TimedMotion> motions = timedRuns(toolpath, limits);
  RunPusher pusher(toolpath, settings, flow_factor);
  std::vector<std::vector<PushedPath>> pushed(toolpath.layers.size());
  for (std::size_t l = 0; l < pushed.size(); ++l)
    for (const Path& path : toolpath.layers[l].paths) pushed[l].emplace_back(path.motionCount());
  for (std::size_t first = 0; first < motions.size();) {
    std::size_t last = first + 1;
    while (last < motions.size() && motions[last].goes_on) ++last;
    std::vector<std::vector<PushedPiece>> pieces = pusher.pieces(&motions[first], motions.data() + last);
    for (std::size_t i = first; i < last; ++i)
      pushed[motions[i].layer][motions[i].path][motions[i].motion] = std::move(pieces[i - first]);
    first = last;
  }
  for (std::size_t l = 0; l < pushed.size(); ++l)
    for (std::size_t p = 0; p < pushed[l].size(); ++p)
      if (Path& path = toolpath.layers[l].paths[p]; laysBeads(path)) path = pushedPath(path, pushed[l][p]);
  return pusher.unmet();
}

}  // namespace lamina
