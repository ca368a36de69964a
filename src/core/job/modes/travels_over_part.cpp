// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/travels_over_part.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "planning/lift/held_along.hpp"
#include "planning/nozzle_frame.hpp"

namespace lamina {
namespace {

constexpr double kSpacingMm = 2.0;
constexpr double kSmallTurn = 0.35;  // rad: by more the nozzle itself, of which no room is known, swings into
constexpr double kRoomToTurnMm = 6.0;  // what is just deposited, unless its tip is so far from that
constexpr std::array<double, 9> kWaysOutMm = {1.0, 3.0, 6.0, 10.0, 15.0, 25.0, 40.0, 60.0, 90.0};

struct HeadPlace {
  Point3 tip;
  Point3 axis;  // against the tool axis
};

HeadPlace placeOf(const Path& path, std::size_t waypoint) {
  return {path.points[waypoint], againstToolAxis(path.orientation.at(waypoint))};
}

double turnBetween(const HeadPlace& from, const HeadPlace& to) {
  return std::acos(std::clamp(from.axis.dot(to.axis), -1.0, 1.0));
}

class TravelLead {
 public:
  TravelLead(const HeadRoom& room, double growth_mm, double over_mm)
      : room_(room), growth_mm_(growth_mm), over_mm_(over_mm) {}

  bool isClear(const Path& travel) const {
    const HeadPlace last = placeOf(travel, travel.points.size() - 1);
    if (turnBetween(placeOf(travel, 0), last) > kSmallTurn) return false;
    for (std::size_t i = 1; i < travel.points.size(); ++i)
      if (!isClear(placeOf(travel, i - 1), placeOf(travel, i))) return false;
    return true;
  }

  /// The travel led out, over and in; nothing if there is no such way.
  std::optional<Path> led(const Path& travel) const {
    const HeadPlace from = placeOf(travel, 0);
    const HeadPlace to = placeOf(travel, travel.points.size() - 1);
    const std::optional<Point3> out = wayOut(from);
    const std::optional<Point3> in = wayOut(to);
    if (!out || !in) return std::nullopt;
    const double z = std::max({over_mm_, out->z(), in->z()});
    const std::vector<HeadPlace> places = {from,
                                           {*out, from.axis},
                                           {*out, Point3::UnitZ()},
                                           {{out->x(), out->y(), z}, Point3::UnitZ()},
                                           {{in->x(), in->y(), z}, Point3::UnitZ()},
                                           {*in, Point3::UnitZ()},
                                           {*in, to.axis},
                                           to};
    Path path = travel;
    path.points.clear();
    std::vector<Eigen::Quaterniond> held;
    for (const HeadPlace& place : places) {
      path.points.push_back(place.tip);
      held.push_back(nozzleAgainst(place.axis));
    }
    held.front() = travel.orientation.at(0);
    held.back() = travel.orientation.at(travel.points.size() - 1);
    path.orientation = heldAlong(std::move(held));
    return path;
  }

 private:
  /// The turn goes on evenly with the way; where the tip stays, in steps of 10 deg at most.
  bool isClear(const HeadPlace& from, const HeadPlace& to) const {
    const double turn = turnBetween(from, to);
    const int steps = std::max(
        1, static_cast<int>(std::ceil(std::max((to.tip - from.tip).norm() / kSpacingMm, turn / 0.17))));
    for (int i = 0; i <= steps; ++i) {
      const double part = static_cast<double>(i) / steps;
      const Point3 axis = ((1.0 - part) * from.axis + part * to.axis).normalized();
      if (!room_.isClear(from.tip + part * (to.tip - from.tip), axis, growth_mm_)) return false;
    }
    return true;
  }

  /// The nearest place along the tool axis from which the head can turn upright and go up.
  std::optional<Point3> wayOut(const HeadPlace& place) const {
    const bool turns_much = turnBetween(place, {place.tip, Point3::UnitZ()}) > kSmallTurn;
    for (const double way : kWaysOutMm) {
      if (turns_much && way < kRoomToTurnMm) continue;
      const HeadPlace out{place.tip + way * place.axis, place.axis};
      if (!isClear({place.tip + std::min(way, 1.0) * place.axis, place.axis}, out)) return std::nullopt;
      const HeadPlace upright{out.tip, Point3::UnitZ()};
      const HeadPlace above{{out.tip.x(), out.tip.y(), std::max(over_mm_, out.tip.z())}, Point3::UnitZ()};
      if (isClear(out, upright) && isClear(upright, above)) return out.tip;
    }
    return std::nullopt;
  }

  const HeadRoom& room_;
  double growth_mm_;
  double over_mm_;
};

/// z of the highest tip up to and with each layer.
std::vector<double> highestTips(const Toolpath& toolpath) {
  std::vector<double> highest;
  double z = -std::numeric_limits<double>::infinity();
  for (const ToolpathLayer& layer : toolpath.layers) {
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points) z = std::max(z, point.z());
    highest.push_back(z);
  }
  return highest;
}

}  // namespace

TravelsOverPart leadTravels(Toolpath& toolpath, const std::vector<double>& growth_mm, const HeadRoom& room,
                            double hop_mm, Progress& progress) {
  if (growth_mm.size() != toolpath.layers.size())
    throw InvalidInput("growth is given of " + std::to_string(growth_mm.size()) + " layers; expected " +
                       std::to_string(toolpath.layers.size()));
  const std::vector<double> highest = highestTips(toolpath);
  std::vector<TravelsOverPart> of_layers(toolpath.layers.size());
  const auto leadLayer = [&](std::size_t i) {
    const TravelLead lead(room, growth_mm[i], highest[i] + hop_mm);
    for (Path& path : toolpath.layers[i].paths) {
      if (path.role != PathRole::Travel || path.points.size() < 2) continue;
      ++of_layers[i].travels;
      if (lead.isClear(path)) continue;
      ++of_layers[i].led_round;
      std::optional<Path> led = lead.led(path);
      if (led)
        path = std::move(*led);
      else
        ++of_layers[i].shut;
    }
  };
  parallelFor(toolpath.layers.size(), leadLayer, progress, "travels");
  TravelsOverPart sum;
  for (const TravelsOverPart& of_layer : of_layers) {
    sum.travels += of_layer.travels;
    sum.led_round += of_layer.led_round;
    sum.shut += of_layer.shut;
  }
  return sum;
}

}  // namespace lamina
