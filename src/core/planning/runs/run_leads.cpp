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
#include "planning/runs/run_entries.hpp"

namespace lamina {
namespace {

constexpr double kArcStep = toRadians(5.0);
constexpr std::size_t kRampSteps = 10;
constexpr double kSampleShare = 0.25;  // of a bead's width, between places that are looked at
constexpr double kLeadRoom = 1e-3;     // mm: by which a lead may be nearer than beads are
constexpr double kSameRoom = 1e-6;     // mm
constexpr double kLeavingShare = 0.5;  // of a lead's way, by which one that leaves its bead goes away from it

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
    for (const LaidMotion& motion : motions) {
      const double first_mm = motion.distanceTo(at);
      if (first_mm <= reach_mm + motion.width_mm) motions_.push_back({motion, motion.path == own, first_mm});
    }
  }

  /// The longest way along which the lead keeps off what is laid. None if it would lie on its own bead along
  /// more than half of that.
  /// @param on_own_mm  from its own path: nearer it lies on the bead, unless it goes straight away
  template <class PointAt>
  double longest(double way_mm, double width_mm, double on_own_mm, PointAt pointAt) const {
    const auto count = static_cast<std::size_t>(std::ceil(way_mm / (kSampleShare * width_mm)));
    const double step_mm = way_mm / static_cast<double>(count);
    double free_mm = 0.0;
    double last_own_mm = 0.0;
    bool has_left = false;
    std::size_t count_on_own = 0;
    std::vector<Nearby> nearby;
    for (std::size_t i = 1; i <= count; ++i) {
      const double at_mm = step_mm * static_cast<double>(i);
      const Point3 point = pointAt(at_mm);
      if (i % kBlock == 1) {
        const double to_last_mm = (pointAt(at_mm + step_mm * kBlock) - point).norm();
        nearby = nearTo(point, 2.0 * to_last_mm + width_mm);
      }
      // What is farther than that is as good as any.
      const double own_mm = std::min(toOwn(nearby, point), width_mm);
      // A lead begins at its own bead, and may go away from it only.
      if (own_mm < last_own_mm - kSameRoom) break;
      if (has_left && own_mm < width_mm - kLeadRoom) break;
      has_left |= own_mm >= width_mm;
      last_own_mm = own_mm;
      if (!keepsOff(nearby, point, width_mm)) break;
      free_mm = at_mm;
      if (own_mm < std::min(on_own_mm, kLeavingShare * at_mm)) ++count_on_own;
    }
    return 2.0 * step_mm * static_cast<double>(count_on_own) > free_mm ? 0.0 : free_mm;
  }

  double toOthers(const Point3& point) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Nearby& each : motions_)
      if (!each.is_own) least = std::min(least, each.motion.distanceTo(point));
    return least;
  }

 private:
  static constexpr std::size_t kBlock = 10;  // places for which what is near is sought once

  struct Nearby {
    LaidMotion motion;
    bool is_own = false;    ///< of the lead's path
    double first_mm = 0.0;  ///< from where the lead begins
  };

  std::vector<Nearby> nearTo(const Point3& point, double reach_mm) const {
    std::vector<Nearby> found;
    for (const Nearby& each : motions_)
      if (each.motion.distanceTo(point) <= reach_mm + each.motion.width_mm) found.push_back(each);
    return found;
  }

  static double toOwn(const std::vector<Nearby>& nearby, const Point3& point) {
    double least = std::numeric_limits<double>::infinity();
    for (const Nearby& each : nearby)
      if (each.is_own) least = std::min(least, each.motion.distanceTo(point));
    return least;
  }

  static bool keepsOff(const std::vector<Nearby>& nearby, const Point3& point, double width_mm) {
    return std::none_of(nearby.begin(), nearby.end(), [&](const Nearby& each) {
      const double need_mm = std::min(0.5 * (width_mm + each.motion.width_mm), each.first_mm);
      return !each.is_own && each.motion.distanceTo(point) < need_mm - kLeadRoom;
    });
  }

  std::vector<Nearby> motions_;
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

/// Where beads grow and fade at the ends of a path, those are no measure of the room that it takes.
double widestPlan(const Path& path) {
  double widest_mm = 0.0;
  for (std::size_t m = 0; m < path.motionCount(); ++m)
    widest_mm = std::max(widest_mm, planWidth(path.bead.at(path.motionEnd(m))));
  return widest_mm;
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
    const double width_mm = widestPlan(path);
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
    // What lays nothing may pass over its bead, but not go along it.
    const double on_own_mm = settings_.deposit == LeadDeposit::Dry ? kLeadRoom : 0.5 * width_mm;
    const auto longest = [&](LeadSide side) {
      return room.longest(whole_mm, width_mm, on_own_mm,
                          [&](double way_mm) { return pointOn(side, way_mm); });
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
    lead.role = settings_.deposit == LeadDeposit::Dry ? PathRole::Travel : PathRole::Prime;
    if (settings_.deposit == LeadDeposit::Bead) lead.bead = bead;
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

/// What is added before and after a path, in this order round it: entry, lead.
struct PathEnds {
  std::optional<Path> entry;
  std::optional<Path> in;
  std::optional<Path> out;
  std::optional<Path> exit;
};

/// Adds leads and entries to all runs.
class RunEndings {
 public:
  RunEndings(Toolpath& toolpath, const LeadSettings& lead, const EntrySettings& entry)
      : toolpath_(toolpath), lead_(lead), entry_(entry), places_(placesOf(toolpath)) {
    for (const ToolpathLayer& layer : toolpath.layers) {
      layers_.emplace_back(layer, lead_);
      ends_.emplace_back(layer.paths.size());
    }
  }

  EndCount add() {
    const std::vector<RunSpan> runs = runsOf(toolpath_, places_);
    for (const RunSpan& run : runs) {
      if (isFree(run.begin - 1)) addLead(run.begin, LeadEnd::In);
      if (isFree(run.end)) addLead(run.end - 1, LeadEnd::Out);
    }
    // Once all leads are known: rooms are those of what was planned.
    for (const RunSpan& run : runs) {
      if (isFree(run.begin - 1)) joinBefore(run.begin);
      if (isFree(run.end)) joinAfter(run.end - 1);
    }
    for (std::size_t l = 0; l < toolpath_.layers.size(); ++l) insert(toolpath_.layers[l].paths, ends_[l]);
    return count_;
  }

 private:
  /// Whether a travel stands there, or nothing: the index before the first is beyond all.
  bool isFree(std::size_t index) const {
    return index >= places_.size() || pathAt(toolpath_, places_[index]).role == PathRole::Travel;
  }

  PathEnds& endsAt(std::size_t index) { return ends_[places_[index].layer][places_[index].path]; }

  void addLead(std::size_t index, LeadEnd end) {
    const RunPlace& place = places_[index];
    std::optional<Path> lead = layers_[place.layer].lead(place.path, end, count_.leads);
    (end == LeadEnd::In ? endsAt(index).in : endsAt(index).out) = std::move(lead);
  }

  void joinBefore(std::size_t index) {
    PathEnds& ends = endsAt(index);
    const Path& path = pathAt(toolpath_, places_[index]);
    const Eigen::Quaterniond nozzle = path.orientation.at(0);
    const Point3 start = ends.in ? ends.in->firstPoint() : path.firstPoint();
    Path* travel = index > 0 ? &pathAt(toolpath_, places_[index - 1]) : nullptr;
    if (ends.in && travel != nullptr) shiftEnd(*travel, startPose(path), {start, nozzle});
    if (ends.in) runAs(*ends.in, path, travel);
    if (entry_.distance_mm == 0.0) return;
    const Point3 from = entryPoint(start, nozzle, entry_);
    if (travel != nullptr) endAtEntry(*travel, from);
    ends.entry = entryTravel(from, start, nozzle, entry_.feed_mm_s);
    runAs(*ends.entry, path, travel);
    ++count_.entries;
  }

  void joinAfter(std::size_t index) {
    PathEnds& ends = endsAt(index);
    const Path& path = pathAt(toolpath_, places_[index]);
    const Eigen::Quaterniond nozzle = nozzleAtEnd(path);
    const Point3 end = ends.out ? ends.out->lastPoint() : path.lastPoint();
    Path* travel = index + 1 < places_.size() ? &pathAt(toolpath_, places_[index + 1]) : nullptr;
    if (ends.out && travel != nullptr) shiftStart(*travel, endPose(path), {end, nozzle});
    if (ends.out) runAs(*ends.out, path, travel);
    if (entry_.distance_mm == 0.0) return;
    const Point3 to = entryPoint(end, nozzle, entry_);
    if (travel != nullptr) startAtEntry(*travel, to);
    ends.exit = entryTravel(end, to, nozzle, entry_.feed_mm_s);
    runAs(*ends.exit, path, travel);
    ++count_.entries;
  }

  /// By the run's tool; and between run and travel the material stays pulled back as on the travel.
  static void runAs(Path& added, const Path& run, const Path* travel) {
    added.tool = run.tool;
    if (added.role == PathRole::Travel && travel != nullptr)
      added.process.is_retracted = travel->process.is_retracted;
  }

  static void insert(std::vector<Path>& paths, std::vector<PathEnds>& ends) {
    std::vector<Path> all;
    const auto take = [&all](std::optional<Path>& path) {
      if (path) all.push_back(std::move(*path));
    };
    for (std::size_t p = 0; p < paths.size(); ++p) {
      take(ends[p].entry);
      take(ends[p].in);
      all.push_back(std::move(paths[p]));
      take(ends[p].out);
      take(ends[p].exit);
    }
    paths = std::move(all);
  }

  Toolpath& toolpath_;
  const LeadSettings& lead_;
  const EntrySettings& entry_;
  std::vector<RunPlace> places_;
  std::vector<LayerLeads> layers_;
  std::vector<std::vector<PathEnds>> ends_;
  EndCount count_;
};

}  // namespace

EndCount addEnds(Toolpath& toolpath, const LeadSettings& lead, const EntrySettings& entry) {
  if (lead.in == LeadShape::None && lead.out == LeadShape::None && entry.distance_mm == 0.0) return {};
  return RunEndings(toolpath, lead, entry).add();
}

}  // namespace lamina
