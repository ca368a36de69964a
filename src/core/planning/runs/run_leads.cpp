// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/planning/runs/runs.hpp"
#include "planning/runs/run_ends.hpp"

namespace lamina {
namespace {

constexpr double kArcStep = toRadians(5.0);
constexpr std::size_t kRampSteps = 10;
constexpr double kSampleShare = 0.25;  // of a bead's width, between places that are looked at
constexpr double kLeadRoom = 1e-3;     // mm: by which a lead may be nearer than beads are
constexpr double kSameRoom = 1e-6;     // mm

enum class LeadSide { Left = 1, Right = -1 };

/// Where a lead meets its run, seen from there.
struct LeadStart {
  Point3 at;
  Point3 along;  ///< on along the bead, away from it
  Point3 left;
  Point3 up;
};

std::optional<LeadStart> leadStart(const Point3& at, const Point3& tangent, const Point3& along,
                                   const Eigen::Quaterniond& nozzle) {
  const Point3 up = -(nozzle * Point3::UnitZ());
  const Point3 left = up.cross(tangent);
  if (left.norm() < kSameRoom) return std::nullopt;
  LeadStart start{at, along, left.normalized(), Point3::Zero()};
  start.up = tangent.cross(start.left).normalized();
  return start;
}

/// Ways are measured in the layer.
double wholeWay(LeadShape shape, const LeadSettings& settings) {
  return shape == LeadShape::Line ? settings.length_mm * std::cos(toRadians(settings.rise_deg))
                                  : settings.radius_mm * toRadians(settings.sweep_deg);
}

Point3 leadPoint(const LeadStart& start, LeadShape shape, LeadSide side, const LeadSettings& settings,
                 double way_mm) {
  const double sign = static_cast<double>(static_cast<int>(side));
  const Point3 risen = start.at + way_mm * std::tan(toRadians(settings.rise_deg)) * start.up;
  if (shape == LeadShape::Line) {
    const double angle = toRadians(settings.angle_deg);
    return risen + way_mm * (std::cos(angle) * start.along + sign * std::sin(angle) * start.left);
  }
  const double turn = way_mm / settings.radius_mm;
  return risen +
         settings.radius_mm * (std::sin(turn) * start.along + sign * (1.0 - std::cos(turn)) * start.left);
}

/// A motion that lays a bead of a layer.
struct LaidMotion {
  Point3 from;
  Point3 to;
  double width_mm = 0.0;
  std::size_t path = 0;

  double distanceTo(const Point3& point) const {
    const Point3 way = to - from;
    const double square = way.squaredNorm();
    const double share = square > 0.0 ? std::clamp((point - from).dot(way) / square, 0.0, 1.0) : 0.0;
    return (point - from - share * way).norm();
  }
};

std::vector<LaidMotion> laidMotions(const ToolpathLayer& layer) {
  std::vector<LaidMotion> motions;
  for (std::size_t p = 0; p < layer.paths.size(); ++p) {
    const Path& path = layer.paths[p];
    if (path.role == PathRole::Travel || path.deposit != Deposit::Bead) continue;
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      motions.push_back({path.points[m], path.points[end], planWidth(path.bead.at(end)), p});
    }
  }
  return motions;
}

/// What is laid near a lead: in its own path, and in others.
class LeadRoom {
 public:
  LeadRoom(const std::vector<LaidMotion>& motions, const Point3& at, double reach_mm, std::size_t own) {
    for (const LaidMotion& motion : motions)
      if (motion.distanceTo(at) <= reach_mm + motion.width_mm)
        (motion.path == own ? own_ : others_).push_back(motion);
    for (const LaidMotion& motion : others_) first_mm_.push_back(motion.distanceTo(at));
  }

  /// The longest way along which the lead keeps off what is laid.
  template <class PointAt>
  double longest(double way_mm, double width_mm, PointAt pointAt) const {
    const auto count = static_cast<std::size_t>(std::ceil(way_mm / (kSampleShare * width_mm)));
    double free_mm = 0.0;
    double last_own_mm = 0.0;
    bool has_left = false;
    for (std::size_t i = 1; i <= count; ++i) {
      const double at_mm = way_mm * static_cast<double>(i) / static_cast<double>(count);
      const Point3 point = pointAt(at_mm);
      const double own_mm = nearest(own_, point);
      // A lead begins at its own bead, and may go away from it only.
      if (own_mm < last_own_mm - kSameRoom && own_mm < width_mm) break;
      if (has_left && own_mm < width_mm - kLeadRoom) break;
      has_left |= own_mm >= width_mm;
      last_own_mm = own_mm;
      if (!keepsOff(point, width_mm)) break;
      free_mm = at_mm;
    }
    return free_mm;
  }

  double toOthers(const Point3& point) const { return nearest(others_, point); }

 private:
  static double nearest(const std::vector<LaidMotion>& motions, const Point3& point) {
    double least = std::numeric_limits<double>::infinity();
    for (const LaidMotion& motion : motions) least = std::min(least, motion.distanceTo(point));
    return least;
  }

  bool keepsOff(const Point3& point, double width_mm) const {
    for (std::size_t i = 0; i < others_.size(); ++i) {
      const double need_mm = std::min(0.5 * (width_mm + others_[i].width_mm), first_mm_[i]);
      if (others_[i].distanceTo(point) < need_mm - kLeadRoom) return false;
    }
    return true;
  }

  std::vector<LaidMotion> own_;
  std::vector<LaidMotion> others_;
  std::vector<double> first_mm_;  ///< of the others, from where the lead begins
};

/// The side away from the inside of a closed way: that of a path whose ends are near each other, too.
LeadSide outside(const Path& path, const Point3& up) {
  double twice_area = 0.0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const Point3& next = path.points[i + 1 < path.points.size() ? i + 1 : 0];
    twice_area += up.dot((path.points[i] - path.points[0]).cross(next - path.points[0]));
  }
  return twice_area > 0.0 ? LeadSide::Right : LeadSide::Left;
}

enum class LeadEnd { In, Out };

/// Makes the leads of one layer.
class LayerLeads {
 public:
  LayerLeads(const ToolpathLayer& layer, const LeadSettings& settings)
      : layer_(layer), settings_(settings), motions_(laidMotions(layer)) {}

  /// Nothing if there is no room; counted.
  std::optional<Path> lead(std::size_t index, LeadEnd end, LeadCount& count) const {
    const Path& path = layer_.paths[index];
    const LeadShape shape = end == LeadEnd::In ? settings_.in : settings_.out;
    if (shape == LeadShape::None) return std::nullopt;
    const std::size_t motion = end == LeadEnd::In ? 0 : path.motionCount() - 1;
    const std::size_t waypoint = path.motionEnd(motion);
    const Point3 tangent = end == LeadEnd::In ? startTangent(path) : endTangent(path);
    const auto start = leadStart(end == LeadEnd::In ? path.firstPoint() : path.lastPoint(), tangent,
                                 end == LeadEnd::In ? Point3(-tangent) : tangent,
                                 end == LeadEnd::In ? path.orientation.at(0) : nozzleAtEnd(path));
    const double width_mm = planWidth(path.bead.at(waypoint));
    if (!start || width_mm <= 0.0) return std::nullopt;
    const auto [side, way_mm] = freeSide(*start, shape, index, width_mm);
    const double whole_mm = wholeWay(shape, settings_);
    if (way_mm < std::min(settings_.least_mm, whole_mm)) {
      ++count.left_out;
      return std::nullopt;
    }
    ++count.added;
    count.shortened += way_mm < whole_mm - kSameRoom ? 1 : 0;
    Path lead = along(*start, shape, side, way_mm);
    lead.feed_mm_s = path.feed_mm_s.at(waypoint);
    lead.orientation = end == LeadEnd::In ? path.orientation.at(0) : nozzleAtEnd(path);
    lead.tool = path.tool;
    deposit(lead, path.bead.at(waypoint));
    if (end == LeadEnd::In) reverse(lead);
    return lead;
  }

 private:
  std::pair<LeadSide, double> freeSide(const LeadStart& start, LeadShape shape, std::size_t index,
                                       double width_mm) const {
    const double whole_mm = wholeWay(shape, settings_);
    const LeadRoom room(motions_, start.at, whole_mm / std::cos(toRadians(settings_.rise_deg)), index);
    const auto pointOn = [&](LeadSide side, double way_mm) {
      return leadPoint(start, shape, side, settings_, way_mm);
    };
    const auto longest = [&](LeadSide side) {
      return room.longest(whole_mm, width_mm, [&](double way_mm) { return pointOn(side, way_mm); });
    };
    const double left_mm = longest(LeadSide::Left);
    const double right_mm = longest(LeadSide::Right);
    if (left_mm > right_mm + kSameRoom) return {LeadSide::Left, left_mm};
    if (right_mm > left_mm + kSameRoom) return {LeadSide::Right, right_mm};
    const double left_room_mm = room.toOthers(pointOn(LeadSide::Left, left_mm));
    const double right_room_mm = room.toOthers(pointOn(LeadSide::Right, left_mm));
    if (left_room_mm > right_room_mm + kSameRoom) return {LeadSide::Left, left_mm};
    if (right_room_mm > left_room_mm + kSameRoom) return {LeadSide::Right, left_mm};
    return {outside(layer_.paths[index], start.up), left_mm};
  }

  /// From the run on.
  Path along(const LeadStart& start, LeadShape shape, LeadSide side, double way_mm) const {
    std::size_t steps = settings_.deposit == LeadDeposit::Ramp ? kRampSteps : 1;
    if (shape == LeadShape::Arc)
      steps = std::max(
          steps, static_cast<std::size_t>(std::ceil(way_mm / settings_.radius_mm / kArcStep - kSameRoom)));
    Path lead;
    lead.points.push_back(start.at);
    for (std::size_t i = 1; i <= steps; ++i)
      lead.points.push_back(leadPoint(start, shape, side, settings_,
                                      way_mm * static_cast<double>(i) / static_cast<double>(steps)));
    return lead;
  }

  void deposit(Path& lead, const Bead& bead) const {
    lead.role = settings_.deposit == LeadDeposit::Off ? PathRole::Travel : PathRole::Prime;
    if (settings_.deposit == LeadDeposit::On) lead.bead = bead;
    if (settings_.deposit != LeadDeposit::Ramp) return;
    const auto steps = static_cast<double>(lead.points.size() - 1);
    std::vector<Bead> beads = {bead};
    for (std::size_t i = 1; i < lead.points.size(); ++i) {
      const double share = 1.0 - (static_cast<double>(i) - 0.5) / steps;
      beads.push_back(beadOfArea(share * crossSection(bead), bead.height_mm));
    }
    lead.bead = AlongPath<Bead>(std::move(beads));
  }

  /// What describes a motion stands at its other end then.
  static void reverse(Path& lead) {
    std::reverse(lead.points.begin(), lead.points.end());
    if (lead.bead.isCommon()) return;
    std::vector<Bead> beads = lead.bead.values();
    std::reverse(beads.begin() + 1, beads.end());
    lead.bead = AlongPath<Bead>(std::move(beads));
  }

  const ToolpathLayer& layer_;
  const LeadSettings& settings_;
  std::vector<LaidMotion> motions_;
};

/// Leads before and after a path.
struct PathLeads {
  std::optional<Path> in;
  std::optional<Path> out;
};

void insertLeads(ToolpathLayer& layer, std::vector<PathLeads>& leads) {
  std::vector<Path> paths;
  for (std::size_t p = 0; p < layer.paths.size(); ++p) {
    if (leads[p].in) paths.push_back(std::move(*leads[p].in));
    paths.push_back(std::move(layer.paths[p]));
    if (leads[p].out) paths.push_back(std::move(*leads[p].out));
  }
  layer.paths = std::move(paths);
}

bool isTravelOrNone(const Toolpath& toolpath, const std::vector<RunPlace>& places, std::size_t index) {
  return index >= places.size() || pathAt(toolpath, places[index]).role == PathRole::Travel;
}

}  // namespace

LeadCount addLeads(Toolpath& toolpath, const LeadSettings& settings) {
  LeadCount count;
  if (settings.in == LeadShape::None && settings.out == LeadShape::None) return count;
  const std::vector<RunPlace> places = placesOf(toolpath);
  std::vector<LayerLeads> layers;
  std::vector<std::vector<PathLeads>> leads;
  for (const ToolpathLayer& layer : toolpath.layers) {
    layers.emplace_back(layer, settings);
    leads.emplace_back(layer.paths.size());
  }
  for (const RunSpan& run : runsOf(toolpath, places)) {
    const RunPlace& first = places[run.begin];
    const RunPlace& last = places[run.end - 1];
    if (run.begin == 0 || isTravelOrNone(toolpath, places, run.begin - 1))
      leads[first.layer][first.path].in = layers[first.layer].lead(first.path, LeadEnd::In, count);
    if (isTravelOrNone(toolpath, places, run.end))
      leads[last.layer][last.path].out = layers[last.layer].lead(last.path, LeadEnd::Out, count);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PathLeads& of_path = leads[places[i].layer][places[i].path];
    const Path& path = pathAt(toolpath, places[i]);
    if (of_path.in && i > 0)
      shiftEnd(pathAt(toolpath, places[i - 1]), of_path.in->firstPoint(),
               path.orientation.at(0) * Point3::UnitZ());
    if (of_path.out && i + 1 < places.size())
      shiftStart(pathAt(toolpath, places[i + 1]), of_path.out->lastPoint(),
                 nozzleAtEnd(path) * Point3::UnitZ());
  }
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l) insertLeads(toolpath.layers[l], leads[l]);
  return count;
}

}  // namespace lamina
