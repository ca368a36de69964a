// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/layer_error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/planning/runs/runs.hpp"
#include "planning/flow/path_cut.hpp"
#include "planning/runs/run_ends.hpp"
#include "planning/runs/weave_shape.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr double kWaveEnd = 1e-9;      // mm
constexpr double kCornerApart = 0.02;  // of a wave
constexpr double kMostAdvance = 6.0;   // of the line for each mm of the tip's way
constexpr double kMostSwing = 2.0;     // waves, as of the settings

std::string shownMm(double value) { return numberText(value) + " mm"; }

/// Waves along a centre line.
struct WaveTrain {
  std::size_t halves = 0;
  double wavelength_mm = 0.0;
};

WaveTrain waveTrain(const WeaveSettings& settings, double length_mm, bool is_closed) {
  const double halves = 2.0 * length_mm / settings.wavelength_mm;
  WaveTrain train;
  // Of a circle the halves are no mirror images: one that ended amid a wave would end ahead of its line.
  const bool is_whole = is_closed || settings.kind == WeaveKind::Circle;
  train.halves = is_whole ? 2 * static_cast<std::size_t>(std::llround(0.5 * halves))
                          : static_cast<std::size_t>(std::llround(halves));
  if (train.halves > 0) train.wavelength_mm = 2.0 * length_mm / static_cast<double>(train.halves);
  return train;
}

/// Ways over which the amplitude of an open run grows and falls [waves]: a quarter of a wave, and so far that
/// the tip goes neither back behind the start nor on beyond the end.
struct WaveRamps {
  double growing = 0.25;
  double falling = 0.25;
};

WaveRamps waveRamps(const WeaveSettings& settings, double wavelength_mm) {
  const WaveReach reach = waveReach(settings.kind);
  const double amplitude = settings.amplitude_mm / wavelength_mm;
  return {std::max(0.25, reach.behind * amplitude), std::max(0.25, reach.ahead * amplitude)};
}

/// Where a way along a path lies.
struct WayPlace {
  std::size_t motion = 0;
  double share = 0.0;
};

/// Finds places along a path.
class WayPlaces {
 public:
  explicit WayPlaces(const Path& path) : path_(path) {
    ends_mm_.reserve(path.motionCount());
    double end_mm = 0.0;
    for (std::size_t m = 0; m < path.motionCount(); ++m) ends_mm_.push_back(end_mm += motionLength(path, m));
  }

  /// @param way_mm  of a closed path round and round
  WayPlace at(double way_mm) const {
    const double all_mm = ends_mm_.back();
    if (path_.is_closed && way_mm > all_mm) way_mm = std::fmod(way_mm, all_mm);
    if (path_.is_closed && way_mm < 0.0) way_mm += all_mm;
    const auto found = std::partition_point(ends_mm_.begin(), ends_mm_.end() - 1,
                                            [way_mm](double end_mm) { return way_mm >= end_mm - kWaveEnd; });
    const auto motion = static_cast<std::size_t>(found - ends_mm_.begin());
    const double begin_mm = motion > 0 ? ends_mm_[motion - 1] : 0.0;
    const double length_mm = motionLength(path_, motion);
    return {motion, length_mm > 0.0 ? std::clamp((way_mm - begin_mm) / length_mm, 0.0, 1.0) : 0.0};
  }

 private:
  const Path& path_;
  std::vector<double> ends_mm_;
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
  // A tip that goes ahead and back passes a corner several times, all but at its waypoints.
  if (waveReach(settings.kind).ahead > 0.0) return ways;
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
  Weave(const Path& path, const WeaveSettings& settings)
      : path_(path),
        settings_(settings),
        train_(waveTrain(settings, length(path), path.is_closed)),
        on_line_(path) {}

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
    std::vector<WayPlace> places;
    std::vector<TipPlace> tips;
    places.reserve(ways.size());
    tips.reserve(ways.size());
    for (const double way_mm : ways) {
      places.push_back(on_line_.at(way_mm));
      tips.push_back(tipAt(way_mm));
      woven.points.push_back(pointAt(tips.back()));
    }
    if (!path_.is_closed) woven.points.back() = path_.lastPoint();
    requireOnward(places, ways, woven);
    takeQuantities(places, woven);
    turnNozzle(tips, woven);
    keepAdvance(ways, woven);
    addRests(ways, woven);
    return woven;
  }

  /// Where the tip is: beside a place of the line, by a share of the amplitude.
  struct TipPlace {
    WayPlace over;
    double left = 0.0;
  };

  void requireRoom() const {
    // Beads that grow or fade swing with the widest.
    double width_mm = 0.0;
    for (std::size_t m = 0; m < path_.motionCount(); ++m)
      width_mm = std::max(width_mm, path_.bead.at(path_.motionEnd(m)).width_mm);
    if (2.0 * settings_.amplitude_mm > width_mm)
      throw InvalidInput("weave.amplitude_mm is " + shownMm(settings_.amplitude_mm) +
                         ", twice which is more than the bead's width, " + shownMm(width_mm) +
                         "; expected half the bead at most");
    if (settings_.amplitude_mm > kMostSwing * train_.wavelength_mm)
      throw InvalidInput("weave.amplitude_mm is " + shownMm(settings_.amplitude_mm) +
                         " with waves that are " + shownMm(train_.wavelength_mm) + " long to fit into " +
                         shownMm(length(path_)) + "; expected an amplitude of two wavelengths at most");
    requireProgress();
    if (std::any_of(path_.events.begin(), path_.events.end(), [this](const PathEvent& placed) {
          return placed.motion > 0 && placed.motion < path_.motionCount();
        }))
      throw InvalidInput("an event stands amid it; expected none where a tip weaves");
  }

  /// A tip that goes back as fast as its line goes on stands still, and lays all there.
  void requireProgress() const {
    if (leastProgress(settings_, train_.wavelength_mm) * kMostAdvance >= 1.0) return;
    const double still_mm = train_.wavelength_mm / (2.0 * M_PI);
    throw InvalidInput("weave.amplitude_mm is " + shownMm(settings_.amplitude_mm) + " with waves that are " +
                       shownMm(train_.wavelength_mm) +
                       " long, and the tip all but stands still where it goes back; expected at most " +
                       shownMm((1.0 - 1.0 / kMostAdvance) * still_mm) + ", or " +
                       shownMm((1.0 + 1.0 / kMostAdvance) * still_mm) + " or more");
  }

  /// A tip that keeps its own feed takes that of its advance on the crest of a sine; other waves count as a
  /// sine that takes as long.
  /// @param way_share  the tip's way for each mm of advance
  void requireSlow(double way_share, const MotionLimits& limits) const {
    const bool is_slower = settings_.feed == WeaveFeed::Tip &&
                           (settings_.kind == WeaveKind::Zigzag || settings_.kind == WeaveKind::Trapezium);
    const double sharp = sharpness(settings_, train_.wavelength_mm);
    for (std::size_t m = 0; m < path_.motionCount(); ++m) {
      const double feed_mm_s = path_.feed_mm_s.at(path_.motionEnd(m)) / (is_slower ? way_share : 1.0);
      const double turn_s = 2.0 * M_PI * feed_mm_s / train_.wavelength_mm;
      const double needed = sharp * settings_.amplitude_mm * turn_s * turn_s;
      if (needed > limits.acceleration_mm_s2)
        throw InvalidInput("weaving by " + shownMm(settings_.amplitude_mm) + " every " +
                           shownMm(train_.wavelength_mm) + " at " + numberText(feed_mm_s) + " mm/s takes " +
                           numberText(needed) + " mm/s2; expected motion.acceleration_mm_s2, " +
                           numberText(limits.acceleration_mm_s2) + " mm/s2, at most");
    }
  }

  /// Amplitude, as a share of the whole: that of an open run grows from nothing and falls to it, so that the
  /// run begins and ends on its centre line.
  double growth(double waves) const {
    if (path_.is_closed) return 1.0;
    const WaveRamps ramps = waveRamps(settings_, train_.wavelength_mm);
    const double all_waves = 0.5 * static_cast<double>(train_.halves);
    return std::min({1.0, waves / ramps.growing, (all_waves - waves) / ramps.falling});
  }

  TipPlace tipAt(double way_mm) const {
    const double waves = way_mm / train_.wavelength_mm;
    const WavePlace place = wavePlace(settings_, waves);
    const double share = growth(waves);
    return {on_line_.at(way_mm + settings_.amplitude_mm * share * place.ahead), share * place.left};
  }

  Point3 pointAt(const TipPlace& tip) const {
    return centreAt(tip.over) + settings_.amplitude_mm * tip.left * leftAt(tip.over);
  }

  /// Across the way, against the tool axis. Near a corner it turns evenly to that between both ways: the tip
  /// would go back on the inside of one at which it turned at once.
  Point3 leftAt(const WayPlace& place) const {
    const Point3 left = (-(nozzleAt(place) * Point3::UnitZ())).cross(alongAt(place));
    return left.norm() > 0.0 ? Point3(left.normalized()) : Point3(Point3::Zero());
  }

  Eigen::Quaterniond nozzleAt(const WayPlace& place) const {
    return path_.orientation.at(place.motion)
        .slerp(place.share, path_.orientation.at(path_.motionEnd(place.motion)));
  }

  Point3 alongAt(const WayPlace& place) const {
    const double length_mm = motionLength(path_, place.motion);
    const double reach_mm = std::min(0.5 * length_mm, train_.wavelength_mm);
    const double from_mm = place.share * length_mm;
    const std::size_t count = path_.motionCount();
    Point3 along = motionWay(path_, place.motion).normalized();
    if (from_mm < reach_mm && (place.motion > 0 || path_.is_closed))
      along = turnedTo(along, (place.motion + count - 1) % count, 1.0 - from_mm / reach_mm);
    else if (length_mm - from_mm < reach_mm && (place.motion + 1 < count || path_.is_closed))
      along = turnedTo(along, (place.motion + 1) % count, 1.0 - (length_mm - from_mm) / reach_mm);
    return along;
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
  }

  /// As it is held over the line where the tip is; a torch that swings turns its tool axis to the side on
  /// which it is.
  void turnNozzle(const std::vector<TipPlace>& tips, Path& woven) const {
    if (path_.orientation.isCommon() && settings_.swing_deg == 0.0) return;
    std::vector<Eigen::Quaterniond> turns;
    turns.reserve(tips.size());
    for (const TipPlace& tip : tips) {
      const Eigen::Quaterniond held = nozzleAt(tip.over);
      const double swing = toRadians(settings_.swing_deg) * tip.left;
      turns.push_back(swing == 0.0 ? held
                                   : Eigen::AngleAxisd(swing, Point3(alongAt(tip.over).normalized())) * held);
    }
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
      throw InvalidInput("motion " + std::to_string(places[m].motion) + ": the tip, " +
                         shownMm(settings_.amplitude_mm) + " (weave.amplitude_mm) aside in a bend, goes " +
                         shownMm(way_mm) + " while " + shownMm(advance_mm) +
                         " of the line are deposited; expected " + shownMm(advance_mm / kMostAdvance) +
                         " at least, on a line that bends less");
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
  const WeaveSettings& settings_;
  WaveTrain train_;
  WayPlaces on_line_;
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
      try {
        const Weave weaving(path, settings);
        if (!weaving.hasWaves()) continue;
        path = weaving.woven(limits);
        ++count;
      } catch (...) {
        rethrowAt(placeText(toolpath, places[i]));
      }
    }
  return count;
}

}  // namespace lamina
