// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/planning/runs/bead_run_settings.hpp"
#include "lamina/planning/runs/runs.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/runs/run_ends.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr double kSameEntry = 1e-6;  // mm

template <class Value>
AlongPath<Value> without(const AlongPath<Value>& along, std::size_t waypoint) {
  if (along.isCommon()) return along;
  std::vector<Value> values = along.values();
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(waypoint));
  return AlongPath<Value>(std::move(values));
}

void removeWaypoint(Path& travel, std::size_t waypoint) {
  travel.points.erase(travel.points.begin() + static_cast<std::ptrdiff_t>(waypoint));
  travel.orientation = without(travel.orientation, waypoint);
  travel.bead = without(travel.bead, waypoint);
  travel.feed_mm_s = without(travel.feed_mm_s, waypoint);
  for (ProcessValue& value : travel.values) value.value = without(value.value, waypoint);
  for (PathEvent& placed : travel.events) placed.motion = std::min(placed.motion, travel.motionCount());
}

/// A travel that ends, or starts, elsewhere: the waypoint next to that may be there already.
void leadTo(Path& travel, std::size_t waypoint, std::size_t next, const Point3& to) {
  travel.points[waypoint] = to;
  if (travel.points.size() > 2 && (travel.points[next] - to).norm() <= kSameEntry)
    removeWaypoint(travel, next);
}

/// Where the tool comes to a place from: along z, or along the tool axis.
Point3 entryPoint(const Point3& place, const Eigen::Quaterniond& nozzle, const EntrySettings& settings) {
  const Point3 away =
      settings.direction == EntryDirection::Level ? Point3::UnitZ() : Point3(-(nozzle * Point3::UnitZ()));
  return place + settings.distance_mm * away;
}

/// The straight way between a place and its entry.
Path entryTravel(const Point3& from, const Point3& to, const Eigen::Quaterniond& nozzle, double feed_mm_s) {
  Path path;
  path.role = PathRole::Travel;
  path.points = {from, to};
  path.orientation = nozzle;
  path.feed_mm_s = feed_mm_s;
  return path;
}

/// The travel ends at an entry: the waypoint before that may be there already.
void endAtEntry(Path& travel, const Point3& entry) {
  leadTo(travel, travel.points.size() - 1, travel.points.size() - 2, entry);
}

/// The same of its start.
void startAtEntry(Path& travel, const Point3& entry) { leadTo(travel, 0, 1, entry); }

constexpr double kArcStep = toRadians(5.0);
constexpr std::size_t kRampSteps = 10;
constexpr double kSampleShare = 0.25;  // of a bead's width, between places that are looked at
constexpr double kLeadRoom = 1e-3;     // mm: by which a lead may be nearer than beads are
constexpr double kSameRoom = 1e-6;     // mm
constexpr double kLeavingShare = 0.5;  // of a lead's way, by which one that leaves its bead goes away from it
constexpr std::size_t kLoopSizes = 16;  // radii that are tried
constexpr double kLoopShare = 0.5;  // of a loop's distance from a straight bead, to which a bent one may come

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

/// Where a lead goes. Ways are measured in the layer.
struct LeadWay {
  LeadShape shape = LeadShape::Line;
  double radius_mm = 0.0;  ///< of an arc or a loop
  double whole_mm = 0.0;
};

LeadWay leadWay(LeadShape shape, const LeadSettings& settings) {
  if (shape == LeadShape::Line)
    return {shape, 0.0, settings.length_mm * std::cos(toRadians(settings.rise_deg))};
  const double sweep = shape == LeadShape::Loop ? 2.0 * M_PI : toRadians(settings.sweep_deg);
  return {shape, settings.radius_mm, settings.radius_mm * sweep};
}

Point3 leadPoint(const LeadStart& start, const LeadWay& way, LeadSide side, const LeadSettings& settings,
                 double way_mm) {
  const double sign = static_cast<double>(static_cast<int>(side));
  const Point3 risen = start.at + way_mm * std::tan(toRadians(settings.rise_deg)) * start.up;
  if (way.shape == LeadShape::Line) {
    const double angle = toRadians(settings.angle_deg);
    return risen + way_mm * (std::cos(angle) * start.along + sign * std::sin(angle) * start.left);
  }
  const double turn = way_mm / way.radius_mm;
  return risen + way.radius_mm * (std::sin(turn) * start.along + sign * (1.0 - std::cos(turn)) * start.left);
}

/// A motion that lays a bead of a layer.
struct BeadMotion {
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

std::vector<BeadMotion> beadMotions(const ToolpathLayer& layer) {
  std::vector<BeadMotion> motions;
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

/// What is deposited near a lead: in its own path, and in others.
class LeadRoom {
 public:
  LeadRoom(const std::vector<BeadMotion>& motions, const Point3& at, double reach_mm, std::size_t own) {
    for (const BeadMotion& motion : motions) {
      const double first_mm = motion.distanceTo(at);
      if (first_mm <= reach_mm + motion.width_mm) motions_.push_back({motion, motion.path == own, first_mm});
    }
  }

  /// The longest way along which the lead keeps off what is deposited. None if it would lie on its own bead
  /// along more than half of that.
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

  /// Whether a loop keeps off what is deposited; of its own path it comes near only where it touches that.
  template <class PointAt>
  bool holds(const LeadWay& loop, double width_mm, PointAt pointAt) const {
    const auto count = static_cast<std::size_t>(std::ceil(loop.whole_mm / (kSampleShare * width_mm)));
    for (std::size_t i = 1; i < count; ++i) {
      const double at_mm = loop.whole_mm * static_cast<double>(i) / static_cast<double>(count);
      const Point3 point = pointAt(at_mm);
      const double straight_mm = loop.radius_mm * (1.0 - std::cos(at_mm / loop.radius_mm));
      const double least_mm = std::min(width_mm, kLoopShare * straight_mm);
      if (toOwn(motions_, point) < least_mm - kLeadRoom || !keepsOff(motions_, point, width_mm)) return false;
    }
    return true;
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
    BeadMotion motion;
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

/// Where a lead is asked for.
struct LeadPlace {
  std::size_t path = 0;  ///< of the layer
  LeadEnd end = LeadEnd::In;
  double run_mm = 0.0;  ///< length of the run that it leads to
};

/// Makes the leads of one layer.
class LayerLeads {
 public:
  LayerLeads(const ToolpathLayer& layer, const LeadSettings& settings)
      : layer_(layer), settings_(settings), motions_(beadMotions(layer)) {}

  /// Nothing if there is no room; counted.
  std::optional<Path> lead(const LeadPlace& place, LeadCount& count) const {
    const auto [index, end, run_mm] = place;
    const Path& path = layer_.paths[index];
    const LeadShape shape = end == LeadEnd::In ? settings_.in : settings_.out;
    if (shape == LeadShape::None) return std::nullopt;
    const std::size_t motion = end == LeadEnd::In ? 0 : path.motionCount() - 1;
    const std::size_t waypoint = path.motionEnd(motion);
    const Point3 tangent = end == LeadEnd::In ? startTangent(path) : endTangent(path);
    const auto start = leadStart(end == LeadEnd::In ? path.firstPoint() : path.lastPoint(), tangent,
                                 end == LeadEnd::In ? Point3(-tangent) : tangent,
                                 end == LeadEnd::In ? path.orientation.at(0) : endOrientation(path));
    const double width_mm = widestPlan(path);
    if (!start || width_mm <= 0.0) return std::nullopt;
    const LeadWay way = leadWay(shape, settings_);
    // Longer than what it leads to, it would lay or heat more beside the part than in it.
    FreeWay free = shape == LeadShape::Loop ? freeLoop(*start, way, {index, end, run_mm}, width_mm)
                                            : freeSide(*start, way, index, width_mm);
    if (shape != LeadShape::Loop) free.length_mm = std::min(free.length_mm, run_mm);
    if (free.length_mm < std::min(settings_.least_mm, way.whole_mm)) {
      ++count.left_out;
      return std::nullopt;
    }
    ++count.added;
    count.shortened += free.length_mm < way.whole_mm - kSameRoom ? 1 : 0;
    Path lead = along(*start, free);
    lead.feed_mm_s = path.feed_mm_s.at(waypoint);
    lead.orientation = end == LeadEnd::In ? path.orientation.at(0) : endOrientation(path);
    deposit(lead, path.bead.at(waypoint));
    if (end == LeadEnd::In) reverse(lead);
    return lead;
  }

  /// Whether nothing is deposited along a straight way from the end of a path or its lead.
  bool isFree(std::size_t index, const Point3& from, const Point3& way) const {
    const double way_mm = way.norm();
    const double width_mm = widestPlan(layer_.paths[index]);
    if (way_mm == 0.0 || width_mm <= 0.0) return false;
    const LeadRoom room(motions_, from, way_mm, index);
    return room.longest(way_mm, width_mm, kLeadRoom, [&](double at_mm) {
      return Point3(from + at_mm / way_mm * way);
    }) >= way_mm - kSameRoom;
  }

 private:
  /// What of a way has room.
  struct FreeWay {
    LeadWay way;
    LeadSide side = LeadSide::Left;
    double length_mm = 0.0;
  };

  /// The greatest loop for which there is room: a part of one would be an arc.
  FreeWay freeLoop(const LeadStart& start, const LeadWay& whole, const LeadPlace& place,
                   double width_mm) const {
    const std::size_t index = place.path;
    const double reach_mm = whole.whole_mm / std::cos(toRadians(settings_.rise_deg));
    const LeadRoom room(motions_, start.at, reach_mm, index);
    const LeadSide outer = outside(layer_.paths[index], start.up);
    for (std::size_t size = kLoopSizes; size > 0; --size) {
      LeadWay way = whole;
      way.radius_mm *= static_cast<double>(size) / kLoopSizes;
      way.whole_mm = 2.0 * M_PI * way.radius_mm;
      if (way.whole_mm > place.run_mm) continue;
      const auto farFromOthers = [&](LeadSide side) {
        return room.toOthers(leadPoint(start, way, side, settings_, 0.5 * way.whole_mm));
      };
      const auto holds = [&](LeadSide side) {
        return room.holds(way, width_mm,
                          [&](double at_mm) { return leadPoint(start, way, side, settings_, at_mm); });
      };
      const bool left = holds(LeadSide::Left);
      const bool right = holds(LeadSide::Right);
      if (!left && !right) continue;
      if (left != right) return {way, left ? LeadSide::Left : LeadSide::Right, way.whole_mm};
      const double left_mm = farFromOthers(LeadSide::Left);
      const double right_mm = farFromOthers(LeadSide::Right);
      if (left_mm > right_mm + kSameRoom) return {way, LeadSide::Left, way.whole_mm};
      if (right_mm > left_mm + kSameRoom) return {way, LeadSide::Right, way.whole_mm};
      return {way, outer, way.whole_mm};
    }
    return {whole, outer, 0.0};
  }

  FreeWay freeSide(const LeadStart& start, const LeadWay& way, std::size_t index, double width_mm) const {
    const double whole_mm = way.whole_mm;
    const LeadRoom room(motions_, start.at, whole_mm / std::cos(toRadians(settings_.rise_deg)), index);
    const auto pointOn = [&](LeadSide side, double way_mm) {
      return leadPoint(start, way, side, settings_, way_mm);
    };
    // What lays nothing may pass over its bead, but not go along it.
    const double on_own_mm = settings_.deposit == LeadDeposit::Dry ? kLeadRoom : 0.5 * width_mm;
    const auto longest = [&](LeadSide side) {
      return room.longest(whole_mm, width_mm, on_own_mm,
                          [&](double way_mm) { return pointOn(side, way_mm); });
    };
    const double left_mm = longest(LeadSide::Left);
    const double right_mm = longest(LeadSide::Right);
    if (left_mm > right_mm + kSameRoom) return {way, LeadSide::Left, left_mm};
    if (right_mm > left_mm + kSameRoom) return {way, LeadSide::Right, right_mm};
    const double left_room_mm = room.toOthers(pointOn(LeadSide::Left, left_mm));
    const double right_room_mm = room.toOthers(pointOn(LeadSide::Right, left_mm));
    if (left_room_mm > right_room_mm + kSameRoom) return {way, LeadSide::Left, left_mm};
    if (right_room_mm > left_room_mm + kSameRoom) return {way, LeadSide::Right, left_mm};
    return {way, outside(layer_.paths[index], start.up), left_mm};
  }

  /// From the run on.
  Path along(const LeadStart& start, const FreeWay& free) const {
    std::size_t steps = settings_.deposit == LeadDeposit::Ramp ? kRampSteps : 1;
    if (free.way.shape != LeadShape::Line)
      steps = std::max(steps, static_cast<std::size_t>(
                                  std::ceil(free.length_mm / free.way.radius_mm / kArcStep - kSameRoom)));
    Path lead;
    lead.points.push_back(start.at);
    for (std::size_t i = 1; i <= steps; ++i)
      lead.points.push_back(leadPoint(start, free.way, free.side, settings_,
                                      free.length_mm * static_cast<double>(i) / static_cast<double>(steps)));
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
  std::vector<BeadMotion> motions_;
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
    requireRunForLead(runs, lead_.in);
    requireRunForLead(runs, lead_.out);
    for (const RunSpan& run : runs) {
      const double run_mm = lengthOf(run);
      if (isFree(run.begin - 1)) addLead(run.begin, LeadEnd::In, run_mm);
      if (isFree(run.end)) addLead(run.end - 1, LeadEnd::Out, run_mm);
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

  void addLead(std::size_t index, LeadEnd end, double run_mm) {
    const RunPlace& place = places_[index];
    std::optional<Path> lead = layers_[place.layer].lead({place.path, end, run_mm}, count_.leads);
    (end == LeadEnd::In ? endsAt(index).in : endsAt(index).out) = std::move(lead);
  }

  double lengthOf(const RunSpan& run) const {
    double run_mm = 0.0;
    for (std::size_t i = run.begin; i < run.end; ++i) run_mm += length(pathAt(toolpath_, places_[i]));
    return run_mm;
  }

  /// A part of closed runs alone, none longer than a lead, was meant otherwise. Beside longer runs, leads of
  /// short ones are shortened. Loops are made smaller.
  void requireRunForLead(const std::vector<RunSpan>& runs, LeadShape shape) const {
    if (runs.empty() || (shape != LeadShape::Line && shape != LeadShape::Arc)) return;
    const double lead_mm =
        shape == LeadShape::Line ? lead_.length_mm : lead_.radius_mm * toRadians(lead_.sweep_deg);
    const RunSpan* longest = nullptr;
    for (const RunSpan& run : runs) {
      const bool is_closed = run.count() == 1 && pathAt(toolpath_, places_[run.begin]).is_closed;
      if (!is_closed || lengthOf(run) > lead_mm) return;
      if (longest == nullptr || lengthOf(run) > lengthOf(*longest)) longest = &run;
    }
    throw InvalidInput(
        placeText(toolpath_, places_[longest->begin]) + ": a lead is " + numberText(lead_mm) + " mm long (" +
        (shape == LeadShape::Line ? "lead.length_mm" : "lead.radius_mm, lead.sweep_deg") +
        "); must be less than the longest closed run, " + numberText(lengthOf(*longest)) + " mm");
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
    const auto along = tangentEntry(places_[index], start, -startTangent(ends.in ? *ends.in : path));
    const Point3 from = along ? *along : entryPoint(start, nozzle, entry_);
    if (travel != nullptr && along)
      shiftEnd(*travel, {start, nozzle}, {from, nozzle});
    else if (travel != nullptr)
      endAtEntry(*travel, from);
    ends.entry = entryTravel(from, start, nozzle, entry_.feed_mm_s);
    runAs(*ends.entry, path, travel);
    ++count_.entries;
  }

  void joinAfter(std::size_t index) {
    PathEnds& ends = endsAt(index);
    const Path& path = pathAt(toolpath_, places_[index]);
    const Eigen::Quaterniond nozzle = endOrientation(path);
    const Point3 end = ends.out ? ends.out->lastPoint() : path.lastPoint();
    Path* travel = index + 1 < places_.size() ? &pathAt(toolpath_, places_[index + 1]) : nullptr;
    if (ends.out && travel != nullptr) shiftStart(*travel, endPose(path), {end, nozzle});
    if (ends.out) runAs(*ends.out, path, travel);
    if (entry_.distance_mm == 0.0) return;
    const auto along = tangentEntry(places_[index], end, endTangent(ends.out ? *ends.out : path));
    const Point3 to = along ? *along : entryPoint(end, nozzle, entry_);
    if (travel != nullptr && along)
      shiftStart(*travel, {end, nozzle}, {to, nozzle});
    else if (travel != nullptr)
      startAtEntry(*travel, to);
    ends.exit = entryTravel(end, to, nozzle, entry_.feed_mm_s);
    runAs(*ends.exit, path, travel);
    ++count_.entries;
  }

  /// Straight on from a run or its lead, where there is room; counted where there is none.
  /// @param away  unit vector
  std::optional<Point3> tangentEntry(const RunPlace& place, const Point3& at, const Point3& away) {
    if (entry_.direction != EntryDirection::Tangent) return std::nullopt;
    if (layers_[place.layer].isFree(place.path, at, entry_.distance_mm * away))
      return at + entry_.distance_mm * away;
    ++count_.without_tangent;
    return std::nullopt;
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
