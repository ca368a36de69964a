// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/cooling/cooling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "lamina/base/parallel.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/timing.hpp"
#include "planning/cooling/fan_schedule.hpp"
#include "planning/cooling/parking.hpp"
#include "planning/cooling/place_interval.hpp"
#include "planning/flow/path_cut.hpp"
#include "planning/overhangs/overhanging_path.hpp"
#include "toolpath/layer_time.hpp"
#include "toolpath/part_begin.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr double kShortestPiece = 0.05;  // mm: nearer to a waypoint no motion is divided

/// A command to the fan, and when it is given.
struct FanOrder {
  FanChange change;
  double time_s = 0.0;
  bool is_moved = false;  ///< no longer at its place
};

/// The motion that the nozzle runs, by the waypoint it begins at.
WaypointIndex motionOf(const Toolpath& toolpath, const WaypointIndex& heading_for) {
  const Path& path = toolpath.layers[heading_for.layer].paths[heading_for.path];
  return {heading_for.layer, heading_for.path,
          (heading_for.waypoint > 0 ? heading_for.waypoint : path.points.size()) - 1};
}

/// Each change at the time when the nozzle gets there.
std::vector<FanOrder> timed(const Toolpath& toolpath, const std::vector<FanChange>& changes,
                            const MotionLimits& limits) {
  std::vector<FanOrder> orders;
  orders.reserve(changes.size());
  ToolpathPlayer player(toolpath, limits);
  double now_s = 0.0;
  NozzleSample sample = player.at(now_s);
  while (orders.size() < changes.size()) {
    const WaypointIndex& place = changes[orders.size()].before;
    if (player.isFinished() || !(motionOf(toolpath, sample.heading_for) < place)) {
      orders.push_back({changes[orders.size()], now_s, false});
      continue;
    }
    now_s = player.nextWaypointTime();
    sample = player.at(now_s);
  }
  return orders;
}

/// Rises at the time when they must be sent, without the lulls that they reach back over.
std::vector<FanOrder> sentEarlier(const std::vector<FanOrder>& wanted, double spin_up_s) {
  std::vector<FanOrder> sent;
  const auto last_share = [&sent] { return sent.empty() ? 0.0 : sent.back().change.share; };
  for (FanOrder order : wanted) {
    if (order.change.share > last_share()) {
      order.time_s = std::max(0.0, order.time_s - spin_up_s);
      order.is_moved = true;
      FanOrder lull = order;
      const auto is_lull = [&order](const FanOrder& before) {
        return before.time_s >= order.time_s && before.change.share <= order.change.share;
      };
      for (; !sent.empty() && is_lull(sent.back()); sent.pop_back()) lull = sent.back();
      if (last_share() == order.change.share) continue;
      // What ran before the lull was more: then the fan falls where the lull began.
      if (last_share() > order.change.share) {
        lull.change.share = order.change.share;
        order = lull;
      }
    }
    sent.push_back(order);
  }
  return sent;
}

/// Where the nozzle is at these times.
std::vector<std::pair<WaypointIndex, Point3>> placesOf(const Toolpath& toolpath,
                                                       const std::vector<FanOrder>& orders,
                                                       const MotionLimits& limits) {
  std::vector<std::pair<WaypointIndex, Point3>> places;
  ToolpathPlayer player(toolpath, limits);
  for (const FanOrder& order : orders) {
    const NozzleSample sample = player.at(order.time_s);
    places.emplace_back(motionOf(toolpath, sample.heading_for), sample.position);
  }
  return places;
}

/// The event at a point within a motion.
void addEventAt(Path& path, std::size_t motion, const Point3& point, double share) {
  const double before_mm = (point - path.points[motion]).norm();
  const double length_mm = motionLength(path, motion);
  if (path.deposit == Deposit::Bead && before_mm > kShortestPiece && length_mm - before_mm > kShortestPiece) {
    path = withWaypoints(path, {{motion, before_mm / length_mm}});
    ++motion;
  }
  addEvent(path, motion, share);
}

/// Adds the changes as events. A change to a greater share comes earlier by the fan's spin-up time, by the
/// estimate with accelerations; motions are divided there. A lower share for less than that time is left out.
/// No event comes before the start of the toolpath.
/// @param changes  in the order of motion
void addSentEarlier(Toolpath& toolpath, const std::vector<FanChange>& changes, double spin_up_s,
                    const MotionLimits& limits) {
  if (changes.empty()) return;
  const std::vector<FanOrder> orders = sentEarlier(timed(toolpath, changes, limits), spin_up_s);
  const auto places = placesOf(toolpath, orders, limits);
  // From the end, so that what is divided leaves the numbers of what is still to come.
  for (std::size_t i = orders.size(); i-- > 0;) {
    const WaypointIndex& place = orders[i].is_moved ? places[i].first : orders[i].change.before;
    Path& path = toolpath.layers[place.layer].paths[place.path];
    if (orders[i].is_moved)
      addEventAt(path, place.waypoint, places[i].second, orders[i].change.share);
    else
      addEvent(path, place.waypoint, orders[i].change.share);
  }
}

constexpr double kTimeTolerance = 0.001;  // of the time asked for
constexpr int kMostSteps = 40;

/// What is slowed down first, next and last.
constexpr std::size_t kGroups = 3;

/// The group of a path; `kGroups` for travels.
std::size_t groupOf(PathRole role) {
  switch (role) {
    case PathRole::Travel:
      return kGroups;
    case PathRole::InnerWall:
      return 1;
    case PathRole::OuterWall:
    case PathRole::TopSkin:
    case PathRole::Ironing:
      return 2;
    default:
      return 0;
  }
}

/// One layer as a toolpath of its own, whose feeds are changed.
class SlowedLayer {
 public:
  SlowedLayer(const ToolpathLayer& layer, const MotionLimits& limits, double least_feed_mm_s)
      : as_planned_(layer), limits_(limits), least_mm_s_(least_feed_mm_s), slowed_(layer) {}

  /// Slows a group down until the layer takes that long, or the group is as slow as it may be.
  /// @return time [s]
  double slow(std::size_t group, double wanted_s) {
    setFactor(group, 0.0);
    double time_s = layerTime(slowed_, limits_);
    if (time_s <= wanted_s) return time_s;
    double slow = 0.0;
    double fast = 1.0;
    for (int step = 0; step < kMostSteps; ++step) {
      const double factor = 0.5 * (slow + fast);
      setFactor(group, factor);
      time_s = layerTime(slowed_, limits_);
      if (std::abs(time_s - wanted_s) <= kTimeTolerance * wanted_s) break;
      (time_s > wanted_s ? slow : fast) = factor;
    }
    return time_s;
  }

  ToolpathLayer take() { return std::move(slowed_); }

 private:
  /// Feeds of the group times the factor, but not below the least one, nor above those planned.
  void setFactor(std::size_t group, double factor) {
    std::vector<Path>& paths = slowed_.paths;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      if (groupOf(paths[p].role) != group) continue;
      std::vector<double> feeds = as_planned_.paths[p].feed_mm_s.values();
      for (double& feed : feeds) feed = std::max(std::min(feed, least_mm_s_), feed * factor);
      paths[p].feed_mm_s = AlongPath<double>(std::move(feeds));
    }
  }

  const ToolpathLayer& as_planned_;
  MotionLimits limits_;
  double least_mm_s_;
  ToolpathLayer slowed_;
};

/// What became of one layer.
struct CooledLayer {
  bool is_slowed = false;
  bool waits = false;
  double dwell_s = 0.0;
  bool is_too_fast = false;
};

class Cooler {
 public:
  Cooler(Toolpath& toolpath, const CoolingSettings& settings, const MotionLimits& limits)
      : toolpath_(toolpath), settings_(settings), limits_(limits), grounds_(parkingGrounds(toolpath)) {}

  CooledLayer coolLayer(std::size_t index) const {
    ToolpathLayer& layer = toolpath_.layers[index];
    CooledLayer cooled;
    const double wanted_s = settings_.least_layer_time_s;
    double time_s = layerTime(layer, limits_);
    if (time_s >= wanted_s) return cooled;
    if (settings_.by != CoolingBy::Dwell) {
      SlowedLayer slowed(layer, limits_, settings_.least_feed_mm_s);
      for (std::size_t group = 0; group < kGroups && time_s < wanted_s * (1.0 - kTimeTolerance); ++group)
        time_s = slowed.slow(group, wanted_s);
      layer = slowed.take();
      cooled.is_slowed = true;
    }
    const bool lacks_time = time_s < wanted_s * (1.0 - kTimeTolerance);
    const bool is_last = index + 1 == toolpath_.layers.size();
    if (!lacks_time || is_last) return cooled;
    if (settings_.by == CoolingBy::Slow) {
      cooled.is_too_fast = true;
      return cooled;
    }
    cooled.dwell_s = wait(index, wanted_s - time_s);
    cooled.waits = true;
    return cooled;
  }

  /// Leads the wait at the end of a layer on to the first bead of the next.
  void goOn(std::size_t index, CooledLayer& cooled) const {
    std::vector<ToolpathLayer>& layers = toolpath_.layers;
    const auto next = std::find_if(layers.begin() + static_cast<std::ptrdiff_t>(index) + 1, layers.end(),
                                   [](const ToolpathLayer& layer) { return !layer.paths.empty(); });
    if (next == layers.end()) return;
    std::vector<Path>& paths = next->paths;
    const auto bead = std::find_if(paths.begin(), paths.end(),
                                   [](const Path& path) { return path.role != PathRole::Travel; });
    if (bead == paths.end()) return;
    std::vector<Path> way(paths.begin(), bead);
    Path& wait = layers[index].paths.back();
    leadOn(wait, way, *bead, grounds_[index], limits_);
    std::copy(way.begin(), way.end(), paths.begin());
    paths.erase(paths.begin() + static_cast<std::ptrdiff_t>(way.size()), bead);
    cooled.dwell_s = std::get<Dwell>(wait.events.front().event).duration_s;
  }

 private:
  /// The ways to the place and back count.
  /// @return how long it dwells [s]
  double wait(std::size_t index, double lacking_s) const {
    ToolpathLayer& layer = toolpath_.layers[index];
    const Path& last = layer.paths.back();
    Path path = parkedWait(last, last.is_closed ? 0 : last.points.size() - 1, grounds_[index].travel_mm_s,
                           grounds_[index], settings_);
    const ToolpathLayer ways = {layer.z_mm, layer.height_mm, {path}};
    const double dwell_s = std::max(0.0, lacking_s - layerTime(ways, limits_));
    std::get<Dwell>(path.events.front().event).duration_s = dwell_s;
    layer.paths.push_back(std::move(path));
    return dwell_s;
  }

  Toolpath& toolpath_;
  const CoolingSettings& settings_;
  const MotionLimits& limits_;
  std::vector<ParkingGround> grounds_;  ///< by layer
};

}  // namespace

CoolingSummary cool(Toolpath& toolpath, const CoolingSettings& settings, const MotionLimits& limits,
                    Progress& progress) {
  CoolingSummary summary;
  if (settings.least_layer_time_s == 0.0) return summary;
  if (settings.interval == CoolingInterval::Place)
    return leavePlacesAlone(toolpath, settings, limits, progress);
  const Cooler cooler(toolpath, settings, limits);
  std::vector<CooledLayer> cooled(toolpath.layers.size());
  parallelFor(
      cooled.size(),
      [&](std::size_t i) {
        if (!toolpath.layers[i].paths.empty()) cooled[i] = cooler.coolLayer(i);
      },
      progress, "cool");
  for (std::size_t i = 0; i < cooled.size(); ++i)
    if (cooled[i].waits) cooler.goOn(i, cooled[i]);
  for (const CooledLayer& layer : cooled) {
    summary.slowed_layers += layer.is_slowed ? 1 : 0;
    summary.dwells += layer.dwell_s > 0.0 ? 1 : 0;
    summary.dwell_s += layer.dwell_s;
    summary.too_fast_layers += layer.is_too_fast ? 1 : 0;
  }
  return summary;
}

double fanShare(double layer_time_s, std::size_t layer, const FanSettings& settings) {
  if (layer < static_cast<std::size_t>(settings.off_layers)) return 0.0;
  if (layer_time_s <= settings.full_below_s) return settings.greatest;
  if (layer_time_s > settings.least_at_s)
    return settings.beyond == FanSettings::WhenSlow::Least ? settings.least : 0.0;
  const double along = (layer_time_s - settings.full_below_s) / (settings.least_at_s - settings.full_below_s);
  return settings.greatest + along * (settings.least - settings.greatest);
}

void addFan(Toolpath& toolpath, const FanSettings& settings, const MotionLimits& limits) {
  if (settings.is_used) {
    const ToolpathTime time = estimateTime(toolpath, limits);
    FanSchedule fan(settings);
    const std::vector<ToolpathLayer>& layers = toolpath.layers;
    std::size_t begin = 0;  // of the part
    for (std::size_t i = 0; i < layers.size(); ++i) {
      if (beginsPart(layers, i)) begin = i;
      if (layers[i].paths.empty()) continue;
      const double end_s = i + 1 < layers.size() ? time.layer_start_s[i + 1] : time.total_s;
      fan.add(layers[i].paths, {i, i - begin, fanShare(end_s - time.layer_start_s[i], i - begin, settings)});
    }
    if (settings.spin_up_s > 0.0)
      addSentEarlier(toolpath, fan.changes(), settings.spin_up_s, limits);
    else
      for (const FanChange& change : fan.changes())
        addEvent(toolpath.layers[change.before.layer].paths[change.before.path], change.before.waypoint,
                 change.share);
    if (fan.isOn()) toolpath.events_at_end.emplace_back(std::in_place_type<FanShare>);
  }
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths) forgetUnsupported(path);
}

}  // namespace lamina
