// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/runs/cut_beads.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "planning/lift/held_along.hpp"
#include "planning/nozzle_frame.hpp"
#include "planning/travel/space_travel.hpp"

namespace lamina {
namespace {

/// What is deposited of a path in one go.
struct Piece {
  std::vector<std::size_t> waypoints;  ///< in turn; of a closed path the first one may come last again
  std::vector<std::size_t> motions;    ///< of the path, between them
  bool begins_turned = false;          ///< held at its start as at its second waypoint
};

class PathCut {
 public:
  PathCut(const Path& path, std::size_t layer, std::size_t number, const HinderedWaypoints& hindered)
      : path_(path), layer_(layer), number_(number), hindered_(hindered) {}

  bool isNeeded() const {
    if (path_.deposit == Deposit::Drops) return false;
    for (std::size_t w = 0; w < path_.points.size(); ++w)
      if (isIn(hindered_.shut, w) || isIn(hindered_.off, w) || isIn(hindered_.turning, w)) return true;
    return false;
  }

  std::vector<Path> pieces() const {
    std::vector<Path> paths;
    for (const Piece& piece : joined(split())) {
      Path path = pathOf(piece);
      if (length(path) >= path.bead.at(path.points.size() - 1).width_mm) paths.push_back(std::move(path));
    }
    return paths;
  }

 private:
  bool isIn(const std::set<WaypointIndex>& waypoints, std::size_t waypoint) const {
    return waypoints.count({layer_, number_, waypoint}) != 0;
  }

  std::vector<Piece> split() const {
    std::vector<Piece> pieces;
    bool goes_on = false;
    for (std::size_t m = 0; m < path_.motionCount(); ++m) {
      const std::size_t end = path_.motionEnd(m);
      if (isIn(hindered_.shut, m) || isIn(hindered_.shut, end) || isIn(hindered_.off, end)) {
        goes_on = false;
        continue;
      }
      const bool turns = isIn(hindered_.turning, end);
      if (!goes_on || turns) pieces.push_back({{m}, {}, turns});
      pieces.back().waypoints.push_back(end);
      pieces.back().motions.push_back(m);
      goes_on = true;
    }
    return pieces;
  }

  /// What ends where a closed path begins goes on there.
  std::vector<Piece> joined(std::vector<Piece> pieces) const {
    if (!path_.is_closed || pieces.size() < 2) return pieces;
    Piece& first = pieces.front();
    Piece& last = pieces.back();
    if (first.begins_turned || first.waypoints.front() != 0 || last.waypoints.back() != 0) return pieces;
    last.waypoints.insert(last.waypoints.end(), first.waypoints.begin() + 1, first.waypoints.end());
    last.motions.insert(last.motions.end(), first.motions.begin(), first.motions.end());
    pieces.erase(pieces.begin());
    return pieces;
  }

  template <class Value>
  static AlongPath<Value> along(const AlongPath<Value>& values, const std::vector<std::size_t>& waypoints) {
    if (values.isCommon()) return values;
    std::vector<Value> each;
    each.reserve(waypoints.size());
    for (const std::size_t waypoint : waypoints) each.push_back(values.at(waypoint));
    return AlongPath<Value>(std::move(each));
  }

  std::vector<PathEvent> eventsOf(const Piece& piece) const {
    std::vector<PathEvent> events;
    for (std::size_t i = 0; i < piece.motions.size(); ++i)
      for (const PathEvent& each : eventsBefore(path_.events, piece.motions[i]))
        events.push_back({i, each.event});
    if (piece.motions.back() + 1 == path_.motionCount())
      for (const PathEvent& each : eventsBefore(path_.events, path_.motionCount()))
        events.push_back({piece.motions.size(), each.event});
    return events;
  }

  Path pathOf(const Piece& piece) const {
    Path path;
    path.role = path_.role;
    path.deposit = path_.deposit;
    path.process = path_.process;
    path.tool = path_.tool;
    path.points.reserve(piece.waypoints.size());
    for (const std::size_t waypoint : piece.waypoints) path.points.push_back(path_.points[waypoint]);
    path.orientation = along(path_.orientation, piece.waypoints);
    if (piece.begins_turned && !path.orientation.isCommon()) {
      std::vector<Eigen::Quaterniond> held = path.orientation.values();
      held[0] = held[1];
      path.orientation = heldAlong(std::move(held));
    }
    path.bead = along(path_.bead, piece.waypoints);
    path.feed_mm_s = along(path_.feed_mm_s, piece.waypoints);
    path.events = eventsOf(piece);
    for (const ProcessValue& value : path_.values)
      path.values.push_back({value.name, along(value.value, piece.waypoints)});
    return path;
  }

  const Path& path_;
  std::size_t layer_;
  std::size_t number_;
  const HinderedWaypoints& hindered_;
};

constexpr double kSame = 1e-9;  // mm

bool isSamePose(const NozzlePose& a, const NozzlePose& b) {
  return (a.point - b.point).norm() <= kSame && a.orientation.angularDistance(b.orientation) <= kSame;
}

/// Off the bead, over, and back, with what else the travel is.
Path overBead(Path travel, const NozzlePose& from, const NozzlePose& to, double off_mm) {
  travel.points = {from.point, from.point + off_mm * againstToolAxis(from.orientation),
                   to.point + off_mm * againstToolAxis(to.orientation), to.point};
  travel.orientation = heldAlong({from.orientation, from.orientation, to.orientation, to.orientation});
  return travel;
}

Path turnOff(const NozzlePose& from, const NozzlePose& to, double feed_mm_s, double off_mm) {
  Path travel;
  travel.role = PathRole::Travel;
  travel.feed_mm_s = feed_mm_s;
  return overBead(std::move(travel), from, to, off_mm);
}

constexpr double kRaise = 3.0;  // times

Path raised(const Path& travel, double off_mm) {
  return overBead(travel, startPose(travel), endPose(travel), std::max(off_mm, kRaise * rise(travel)));
}

/// Puts paths one after the other, with travels between them.
class Assembly {
 public:
  Assembly(Toolpath& toolpath, const TravelMaker& travel, double off_mm)
      : toolpath_(toolpath), travel_(travel), off_mm_(off_mm) {}

  void addTravel(std::size_t layer, Path path) {
    feed_mm_s_ = path.feed_mm_s.at(path.points.size() - 1);
    travels_.push_back({layer, std::move(path)});
  }

  /// @param stays  whether it starts where the travels before it lead
  void addBead(std::size_t layer, Path path, bool stays) {
    const bool is_led = stays && is_led_;
    if (is_led || !has_last_) {
      if (is_led) flush();
    } else if (std::optional<Path> way = wayTo(path, layer)) {
      toolpath_.layers[layer].paths.push_back(std::move(*way));
    }
    travels_.clear();
    is_led_ = has_last_ = true;
    last_ = {layer, toolpath_.layers[layer].paths.size()};
    toolpath_.layers[layer].paths.push_back(std::move(path));
  }

  /// The travels that come next led on from a bead that is no more.
  void loseEnd() { is_led_ = false; }

  void end() {
    if (is_led_) flush();
  }

  std::size_t turns() const { return turns_; }

 private:
  struct Travel {
    std::size_t layer;
    Path path;
  };

  void flush() {
    for (Travel& each : travels_) toolpath_.layers[each.layer].paths.push_back(std::move(each.path));
  }

  std::optional<Path> wayTo(const Path& path, std::size_t layer) {
    const Path& last = toolpath_.layers[last_.layer].paths[last_.path];
    const NozzlePose from = endPose(last);
    const NozzlePose to = startPose(path);
    if ((from.point - to.point).norm() > kSame) return travel_(last, path, layer);
    if (isSamePose(from, to)) return std::nullopt;
    ++turns_;
    return turnOff(from, to, feed_mm_s_, off_mm_);
  }

  Toolpath& toolpath_;
  const TravelMaker& travel_;
  double off_mm_;
  std::vector<Travel> travels_;
  WaypointIndex last_;  ///< the bead before
  bool has_last_ = false;
  bool is_led_ = true;
  double feed_mm_s_ = 100.0;
  std::size_t turns_ = 0;
};

bool startsAlike(const Path& a, const Path& b) { return isSamePose(startPose(a), startPose(b)); }
bool endsAlike(const Path& a, const Path& b) { return isSamePose(endPose(a), endPose(b)); }

}  // namespace

double rise(const Path& travel) {
  if (travel.points.size() < 3) return 0.0;
  return std::max(0.0, (travel.points[1] - travel.points[0]).dot(againstToolAxis(travel.orientation.at(0))));
}

CutBeads cutBeads(Toolpath toolpath, const HinderedWaypoints& hindered, const TravelMaker& travel,
                  double off_mm) {
  CutBeads cut;
  std::vector<std::vector<Path>> paths;
  for (ToolpathLayer& layer : toolpath.layers) paths.push_back(std::exchange(layer.paths, {}));
  Assembly assembly(toolpath, travel, off_mm);
  for (std::size_t l = 0; l < paths.size(); ++l)
    for (std::size_t p = 0; p < paths[l].size(); ++p) {
      Path& path = paths[l][p];
      if (path.role == PathRole::Travel) {
        assembly.addTravel(l, hindered.low.count({l, p, 0}) != 0 ? raised(path, off_mm) : std::move(path));
        continue;
      }
      const PathCut cutter(path, l, p, hindered);
      if (!cutter.isNeeded()) {
        assembly.addBead(l, std::move(path), true);
        continue;
      }
      std::vector<Path> pieces = cutter.pieces();
      cut.left_out_mm3 += depositedVolume(path);
      const bool keeps_end = !pieces.empty() && endsAlike(pieces.back(), path);
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        cut.left_out_mm3 -= depositedVolume(pieces[i]);
        const bool stays = i == 0 && startsAlike(pieces[i], path);
        assembly.addBead(l, std::move(pieces[i]), stays);
      }
      if (!keeps_end) assembly.loseEnd();
    }
  assembly.end();
  cut.turns = assembly.turns();
  cut.toolpath = std::move(toolpath);
  return cut;
}

}  // namespace lamina
