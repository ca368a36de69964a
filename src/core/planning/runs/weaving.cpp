// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/planning/runs/runs.hpp"
#include "planning/flow/path_cut.hpp"
#include "planning/runs/run_ends.hpp"

namespace lamina {
namespace {

constexpr double kWaveEnd = 1e-9;        // mm
constexpr double kCornerApart = 0.02;    // of a wave
constexpr double kMostAdvance = 6.0;     // of the line for each mm of the tip's way
constexpr double kMostSwing = 2.0;       // waves, as of the settings
constexpr std::size_t kMostInHalf = 64;  // points of half a wave

[[noreturn]] void refuseWeave(const RunPlace& place, const std::string& what) {
  throw InvalidInput("toolpath layer " + std::to_string(place.layer) + ", path " +
                     std::to_string(place.path) + ": " + what);
}

std::string shownMm(double value) { return numberText(value) + " mm"; }

/// Side, as a share of the amplitude, at a phase of the wave [waves].
double swing(const WeaveSettings& settings, double waves) {
  const double phase = waves - std::floor(waves);
  if (settings.kind == WeaveKind::Sine) return std::sin(2.0 * M_PI * phase);
  // The slope of a zigzag, or a steeper one that is cut off at both sides.
  const double flat = settings.kind == WeaveKind::Trapezium ? settings.flat_share : 0.0;
  const double triangle = phase < 0.25 ? 4.0 * phase : phase < 0.75 ? 2.0 - 4.0 * phase : 4.0 * phase - 4.0;
  return std::clamp(triangle / (1.0 - 2.0 * flat), -1.0, 1.0);
}

/// Phases of half a wave at which waypoints stand, the first left out [waves].
std::vector<double> halfWavePhases(const WeaveSettings& settings, double wavelength_mm) {
  if (settings.kind == WeaveKind::Zigzag) return {0.25, 0.5};
  if (settings.kind == WeaveKind::Trapezium)
    return {0.25 - 0.5 * settings.flat_share, 0.25 + 0.5 * settings.flat_share, 0.5};
  // A chord of length d is off a curve of curvature k by k d² / 8.
  const double turn = 2.0 * M_PI / wavelength_mm;
  const double step_mm = std::sqrt(8.0 * settings.tolerance_mm / (settings.amplitude_mm * turn * turn));
  const auto quarters = static_cast<std::size_t>(std::ceil(0.25 * wavelength_mm / step_mm));
  const std::size_t count = 2 * std::clamp<std::size_t>(quarters, 1, kMostInHalf / 2);
  std::vector<double> phases;
  for (std::size_t i = 1; i <= count; ++i)
    phases.push_back(0.5 * static_cast<double>(i) / static_cast<double>(count));
  return phases;
}

/// Waves along a centre line.
struct WaveTrain {
  std::size_t halves = 0;
  double wavelength_mm = 0.0;
};

WaveTrain waveTrain(const WeaveSettings& settings, double length_mm, bool is_closed) {
  const double halves = 2.0 * length_mm / settings.wavelength_mm;
  WaveTrain train;
  train.halves = is_closed ? 2 * static_cast<std::size_t>(std::llround(0.5 * halves))
                           : static_cast<std::size_t>(std::llround(halves));
  if (train.halves > 0) train.wavelength_mm = 2.0 * length_mm / static_cast<double>(train.halves);
  return train;
}

/// Amplitude, as a share of the whole: it grows over the first quarter of an open run's first wave and falls
/// over its last, so that the run begins and ends on its centre line.
double growth(double waves, double all_waves, bool is_closed) {
  if (is_closed) return 1.0;
  return std::min({1.0, 4.0 * waves, 4.0 * (all_waves - waves)});
}

/// Where a way along a path lies.
struct WayPlace {
  std::size_t motion = 0;
  double share = 0.0;
};

/// Finds places from the start on.
class WayCursor {
 public:
  explicit WayCursor(const Path& path) : path_(path) {}

  WayPlace at(double way_mm) {
    while (motion_ + 1 < path_.motionCount() && way_mm >= begin_mm_ + motionLength(path_, motion_) - kWaveEnd)
      begin_mm_ += motionLength(path_, motion_++);
    const double length_mm = motionLength(path_, motion_);
    return {motion_, length_mm > 0.0 ? std::clamp((way_mm - begin_mm_) / length_mm, 0.0, 1.0) : 0.0};
  }

 private:
  const Path& path_;
  std::size_t motion_ = 0;
  double begin_mm_ = 0.0;
};

Point3 motionWay(const Path& path, std::size_t motion) {
  return path.points[path.motionEnd(motion)] - path.points[motion];
}

/// Ways at which waypoints stand: those of the wave, and the corners of the centre line.
std::vector<double> weaveWays(const Path& path, const WeaveSettings& settings, const WaveTrain& train) {
  std::vector<double> ways = {0.0};
  const std::vector<double> phases = halfWavePhases(settings, train.wavelength_mm);
  for (std::size_t half = 0; half < train.halves; ++half)
    for (const double phase : phases)
      ways.push_back((0.5 * static_cast<double>(half) + phase) * train.wavelength_mm);
  // A corner right beside a waypoint of the wave needs none of its own.
  const std::size_t waves = ways.size();
  const double apart_mm = kCornerApart * train.wavelength_mm;
  double corner_mm = 0.0;
  for (std::size_t m = 0; m + 1 < path.motionCount(); ++m) {
    corner_mm += motionLength(path, m);
    const auto end = ways.begin() + static_cast<std::ptrdiff_t>(waves);
    const auto next = std::lower_bound(ways.begin(), end, corner_mm);
    const double after_mm = next == end ? apart_mm : *next - corner_mm;
    const double before_mm = next == ways.begin() ? apart_mm : corner_mm - *(next - 1);
    if (std::min(after_mm, before_mm) >= apart_mm) ways.push_back(corner_mm);
  }
  std::sort(ways.begin(), ways.end());
  ways.erase(std::unique(ways.begin(), ways.end(),
                         [](double a, double b) { return std::abs(a - b) < 1e3 * kWaveEnd; }),
             ways.end());
  return ways;
}

/// One path, woven.
class Weave {
 public:
  /// All must outlive it.
  Weave(const Path& path, const RunPlace& place, const WeaveSettings& settings)
      : path_(path),
        place_(place),
        settings_(settings),
        train_(waveTrain(settings, length(path), path.is_closed)) {}

  bool hasWaves() const { return train_.halves > 0; }

  /// @throws InvalidInput naming the path: if it is too narrow or short for the swing, or bends more sharply
  ///   than the tip can swing; if an event stands amid it, or it takes more acceleration than there is
  Path woven(const MotionLimits& limits) const {
    requireRoom();
    Path woven = swung();
    requireSlow(length(woven) / length(path_), limits);
    return woven;
  }

 private:
  Path swung() const {
    std::vector<double> ways = weaveWays(path_, settings_, train_);
    if (path_.is_closed) ways.pop_back();
    Path woven = path_;
    woven.points.clear();
    WayCursor cursor(path_);
    std::vector<WayPlace> places;
    places.reserve(ways.size());
    for (const double way_mm : ways) places.push_back(cursor.at(way_mm));
    for (std::size_t i = 0; i < ways.size(); ++i) woven.points.push_back(pointAt(places[i], ways[i]));
    if (!path_.is_closed) woven.points.back() = path_.lastPoint();
    requireOnward(places, ways, woven);
    takeQuantities(places, woven);
    keepAdvance(ways, woven);
    addRests(ways, woven);
    return woven;
  }

  void requireRoom() const {
    // Beads that grow or fade swing with the widest.
    double width_mm = 0.0;
    for (std::size_t m = 0; m < path_.motionCount(); ++m)
      width_mm = std::max(width_mm, path_.bead.at(path_.motionEnd(m)).width_mm);
    if (2.0 * settings_.amplitude_mm > width_mm)
      refuseWeave(place_, "weave.amplitude_mm is " + shownMm(settings_.amplitude_mm) +
                              ", twice which is more than the bead's width, " + shownMm(width_mm) +
                              "; expected half the bead at most");
    if (settings_.amplitude_mm > kMostSwing * train_.wavelength_mm)
      refuseWeave(place_, "weave.amplitude_mm is " + shownMm(settings_.amplitude_mm) +
                              " with waves that are " + shownMm(train_.wavelength_mm) + " long to fit into " +
                              shownMm(length(path_)) + "; expected an amplitude of two wavelengths at most");
    if (std::any_of(path_.events.begin(), path_.events.end(), [this](const PathEvent& placed) {
          return placed.motion > 0 && placed.motion < path_.motionCount();
        }))
      refuseWeave(place_, "an event stands amid it; expected none where a tip weaves");
  }

  /// A tip that keeps its own feed takes that of its advance on the crest of a sine; other waves count as a
  /// sine that takes as long.
  /// @param way_share  the tip's way for each mm of advance
  void requireSlow(double way_share, const MotionLimits& limits) const {
    const bool is_slower = settings_.feed == WeaveFeed::Tip && settings_.kind != WeaveKind::Sine;
    for (std::size_t m = 0; m < path_.motionCount(); ++m) {
      const double feed_mm_s = path_.feed_mm_s.at(path_.motionEnd(m)) / (is_slower ? way_share : 1.0);
      const double turn_s = 2.0 * M_PI * feed_mm_s / train_.wavelength_mm;
      const double needed = settings_.amplitude_mm * turn_s * turn_s;
      if (needed > limits.acceleration_mm_s2)
        refuseWeave(place_, "weaving by " + shownMm(settings_.amplitude_mm) + " every " +
                                shownMm(train_.wavelength_mm) + " at " + numberText(feed_mm_s) +
                                " mm/s takes " + numberText(needed) +
                                " mm/s2; expected motion.acceleration_mm_s2, " +
                                numberText(limits.acceleration_mm_s2) + " mm/s2, at most");
    }
  }

  Point3 pointAt(const WayPlace& place, double way_mm) const {
    const double waves = way_mm / train_.wavelength_mm;
    const double side_mm = settings_.amplitude_mm *
                           growth(waves, 0.5 * static_cast<double>(train_.halves), path_.is_closed) *
                           swing(settings_, waves);
    return centreAt(place) + side_mm * leftAt(place);
  }

  /// Across the way, against the jet. Near a corner it turns evenly to that between both ways: the tip would
  /// go back on the inside of one at which it turned at once.
  Point3 leftAt(const WayPlace& place) const {
    const std::size_t end = path_.motionEnd(place.motion);
    const Eigen::Quaterniond nozzle =
        path_.orientation.at(place.motion).slerp(place.share, path_.orientation.at(end));
    const double length_mm = motionLength(path_, place.motion);
    const double reach_mm = std::min(0.5 * length_mm, train_.wavelength_mm);
    const double from_mm = place.share * length_mm;
    const std::size_t count = path_.motionCount();
    Point3 along = motionWay(path_, place.motion).normalized();
    if (from_mm < reach_mm && (place.motion > 0 || path_.is_closed))
      along = turnedTo(along, (place.motion + count - 1) % count, 1.0 - from_mm / reach_mm);
    else if (length_mm - from_mm < reach_mm && (place.motion + 1 < count || path_.is_closed))
      along = turnedTo(along, (place.motion + 1) % count, 1.0 - (length_mm - from_mm) / reach_mm);
    const Point3 left = (-(nozzle * Point3::UnitZ())).cross(along);
    return left.norm() > 0.0 ? Point3(left.normalized()) : Point3(Point3::Zero());
  }

  /// A share of the way to the direction between that of a motion and its neighbour's.
  Point3 turnedTo(const Point3& along, std::size_t neighbour, double share) const {
    const Point3 between = (along + motionWay(path_, neighbour).normalized()).normalized();
    return (1.0 - share) * along + share * between;
  }

  template <class Value>
  AlongPath<Value> taken(const AlongPath<Value>& along, const std::vector<WayPlace>& places) const {
    if (along.isCommon()) return along;
    std::vector<Value> values;
    for (std::size_t i = 0; i < places.size(); ++i) {
      // What describes the motion to a waypoint stands at the end of the motion that it lies on.
      const bool is_corner = places[i].share * motionWay(path_, places[i].motion).norm() < 1e3 * kWaveEnd;
      const bool is_start = places[i].motion == 0;
      values.push_back(along.at(is_corner && (!is_start || path_.is_closed)
                                    ? places[i].motion
                                    : path_.motionEnd(places[i].motion)));
    }
    return AlongPath<Value>(std::move(values));
  }

  void takeQuantities(const std::vector<WayPlace>& places, Path& woven) const {
    woven.bead = taken(path_.bead, places);
    woven.feed_mm_s = taken(path_.feed_mm_s, places);
    for (std::size_t k = 0; k < path_.values.size(); ++k)
      woven.values[k].value = taken(path_.values[k].value, places);
    if (path_.orientation.isCommon()) return;
    std::vector<Eigen::Quaterniond> turns;
    turns.reserve(places.size());
    for (const WayPlace& place : places)
      turns.push_back(path_.orientation.at(place.motion)
                          .slerp(place.share, path_.orientation.at(path_.motionEnd(place.motion))));
    woven.orientation = AlongPath<Eigen::Quaterniond>(std::move(turns));
  }

  double advanceOf(const std::vector<double>& ways, std::size_t motion) const {
    return (motion + 1 < ways.size() ? ways[motion + 1] : length(path_)) - ways[motion];
  }

  Point3 centreAt(const WayPlace& place) const {
    return path_.points[place.motion] + place.share * motionWay(path_, place.motion);
  }

  /// On the inside of a bend whose radius is the amplitude the tip stands still.
  void requireOnward(const std::vector<WayPlace>& places, const std::vector<double>& ways,
                     const Path& woven) const {
    for (std::size_t m = 0; m < woven.motionCount(); ++m) {
      const double advance_mm = advanceOf(ways, m);
      const double way_mm = motionLength(woven, m);
      if (advance_mm <= kMostAdvance * way_mm) continue;
      refuseWeave(place_, "motion " + std::to_string(places[m].motion) + ": the tip, " +
                              shownMm(settings_.amplitude_mm) +
                              " (weave.amplitude_mm) aside in a bend, goes " + shownMm(way_mm) + " while " +
                              shownMm(advance_mm) + " of the line are laid; expected " +
                              shownMm(advance_mm / kMostAdvance) + " at least, on a line that bends less");
    }
  }

  /// The tip goes farther than its centre: the bead of each motion is the thinner, the feed higher where it
  /// is that of the advance.
  void keepAdvance(const std::vector<double>& ways, Path& woven) const {
    const std::size_t count = woven.points.size();
    std::vector<Bead> beads(count);
    std::vector<double> feeds(count);
    for (std::size_t i = 0; i < count; ++i) beads[i] = woven.bead.at(i), feeds[i] = woven.feed_mm_s.at(i);
    for (std::size_t m = 0; m < woven.motionCount(); ++m) {
      const std::size_t end = woven.motionEnd(m);
      const double share = advanceOf(ways, m) / motionLength(woven, m);
      beads[end] = beadOfArea(share * crossSection(beads[end]), beads[end].height_mm);
      if (settings_.feed == WeaveFeed::Advance) feeds[end] /= share;
    }
    woven.bead = AlongPath<Bead>(std::move(beads));
    woven.feed_mm_s = AlongPath<double>(std::move(feeds));
  }

  void addRests(const std::vector<double>& ways, Path& woven) const {
    std::vector<PathEvent> events;
    for (const PathEvent& placed : path_.events)
      events.push_back({placed.motion == 0 ? 0 : woven.motionCount(), placed.event});
    const auto last =
        std::find_if(events.begin(), events.end(), [](const PathEvent& placed) { return placed.motion > 0; });
    std::vector<PathEvent> rests;
    for (std::size_t half = 0; half < train_.halves; ++half) {
      const double duration_s = half % 2 == 0 ? settings_.left_s : settings_.right_s;
      const double at_mm = (0.5 * static_cast<double>(half) + restPhase()) * train_.wavelength_mm;
      const auto found = std::lower_bound(ways.begin(), ways.end(), at_mm - 1e3 * kWaveEnd);
      if (duration_s > 0.0 && found != ways.end())
        rests.push_back({static_cast<std::size_t>(found - ways.begin()), Dwell{duration_s}});
    }
    events.insert(last, rests.begin(), rests.end());
    woven.events = std::move(events);
  }

  /// The far side; of a trapezium where it ends.
  double restPhase() const {
    return settings_.kind == WeaveKind::Trapezium ? 0.25 + 0.5 * settings_.flat_share : 0.25;
  }

  const Path& path_;
  const RunPlace& place_;
  const WeaveSettings& settings_;
  WaveTrain train_;
};

}  // namespace

std::size_t weave(Toolpath& toolpath, const WeaveSettings& settings, const MotionLimits& limits) {
  if (settings.kind == WeaveKind::None) return 0;
  std::size_t count = 0;
  const std::vector<RunPlace> places = placesOf(toolpath);
  for (const RunSpan& run : runsOf(toolpath, places))
    for (std::size_t i = run.begin; i < run.end; ++i) {
      Path& path = pathAt(toolpath, places[i]);
      if (!isOfPart(path)) continue;
      const Weave weaving(path, places[i], settings);
      if (!weaving.hasWaves()) continue;
      path = weaving.woven(limits);
      ++count;
    }
  return count;
}

}  // namespace lamina
