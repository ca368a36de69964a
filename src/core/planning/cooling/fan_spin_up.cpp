// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cooling/fan_spin_up.hpp"

#include <algorithm>
#include <utility>

#include "lamina/toolpath/timing.hpp"
#include "planning/flow/path_cut.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr double kShortestPiece = 0.05;  // mm: nearer to a waypoint no motion is divided

/// When the fan is told what.
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

}  // namespace

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

}  // namespace lamina
