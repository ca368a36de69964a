// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/runs/run_ends.hpp"

#include <algorithm>
#include <utility>

#include "lamina/base/layer_error.hpp"
#include "toolpath/deposited_segment.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr double kSameRunPose = 1e-6;  // mm and rad
constexpr double kOnAxis = 1e-6;       // mm

bool continuesRun(const Path& before, const Path& path) {
  return laysBeads(before) && laysBeads(path) &&
         (before.lastPoint() - path.firstPoint()).norm() <= kSameRunPose &&
         endOrientation(before).angularDistance(path.orientation.at(0)) <= kSameRunPose;
}

bool standsAbove(const Point3& point, const Point3& end, const Point3& axis) {
  const Point3 offset = point - end;
  return (offset - axis * axis.dot(offset)).norm() <= kOnAxis;
}

/// Moves the waypoints of a travel from its end on, as long as they stand above it.
class EndShift {
 public:
  EndShift(Path& travel, const Point3& end, const NozzlePose& from, const NozzlePose& to)
      : travel_(travel),
        end_(end),
        axis_(from.orientation * Point3::UnitZ()),
        to_(to),
        turn_(to.orientation * from.orientation.conjugate()),
        is_turned_(from.orientation.angularDistance(to.orientation) > kSameRunPose),
        last_(end),
        new_last_(to.point) {}

  /// @return whether the waypoint stood there
  bool take(std::size_t waypoint) {
    Point3& point = travel_.points[waypoint];
    const Point3 before = point;
    if (standsAbove(before, end_, axis_)) {
      point = is_turned_ ? Point3(to_.point + turn_ * (before - end_)) : Point3(before + (to_.point - end_));
    } else if (standsAbove(before, last_, Point3::UnitZ())) {
      point << new_last_.head<2>(), std::max(before.z(), new_last_.z());
    } else {
      return false;
    }
    last_ = before;
    new_last_ = point;
    if (is_turned_) turnAt(waypoint);
    return true;
  }

 private:
  void turnAt(std::size_t waypoint) {
    std::vector<Eigen::Quaterniond> each = travel_.orientation.values();
    if (travel_.orientation.isCommon()) each.resize(travel_.points.size(), Eigen::Quaterniond(each.front()));
    each[waypoint] = to_.orientation;
    travel_.orientation = AlongPath<Eigen::Quaterniond>(std::move(each));
  }

  Path& travel_;
  Point3 end_;
  Point3 axis_;
  NozzlePose to_;
  Eigen::Quaterniond turn_;
  bool is_turned_;
  Point3 last_;      ///< waypoint taken before, where it stood
  Point3 new_last_;  ///< and where it stands
};

}  // namespace

bool isOfPart(const Path& path) {
  return isPartOfPart(path) && path.role != PathRole::Ironing && path.deposit == Deposit::Bead;
}

std::string placeText(const Toolpath& toolpath, const RunPlace& place) {
  return pathPlace(place.layer, toolpath.layers[place.layer].z_mm, place.path);
}

std::vector<RunPlace> placesOf(const Toolpath& toolpath) {
  std::vector<RunPlace> places;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p) places.push_back({l, p});
  return places;
}

std::vector<RunSpan> beadRunsOf(const Toolpath& toolpath, const std::vector<RunPlace>& places) {
  std::vector<RunSpan> runs;
  for (std::size_t i = 0; i < places.size();) {
    const std::size_t begin = i++;
    if (!laysBeads(pathAt(toolpath, places[begin]))) continue;
    while (i < places.size() && continuesRun(pathAt(toolpath, places[i - 1]), pathAt(toolpath, places[i])))
      ++i;
    runs.push_back({begin, i});
  }
  return runs;
}

std::vector<RunSpan> runsOf(const Toolpath& toolpath, const std::vector<RunPlace>& places) {
  std::vector<RunSpan> runs = beadRunsOf(toolpath, places);
  runs.erase(std::remove_if(runs.begin(), runs.end(),
                            [&](const RunSpan& run) {
                              const auto begin = places.begin() + static_cast<std::ptrdiff_t>(run.begin);
                              const auto end = places.begin() + static_cast<std::ptrdiff_t>(run.end);
                              return std::none_of(begin, end, [&](const RunPlace& place) {
                                return isOfPart(pathAt(toolpath, place));
                              });
                            }),
             runs.end());
  return runs;
}

RunTravels travelsOf(Toolpath& toolpath, const std::vector<RunPlace>& places, const RunSpan& run) {
  RunTravels travels;
  const auto travelAt = [&](std::size_t index) -> Path* {
    Path& path = pathAt(toolpath, places[index]);
    if (path.role == PathRole::Travel) return &path;
    travels.is_joined = true;
    return nullptr;
  };
  if (run.begin > 0) travels.before = travelAt(run.begin - 1);
  if (run.end < places.size()) travels.after = travelAt(run.end);
  return travels;
}

Point3 startTangent(const Path& path) {
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const Point3 way = path.points[path.motionEnd(m)] - path.points[m];
    if (way.norm() > 0.0) return way.normalized();
  }
  return Point3::Zero();
}

Point3 endTangent(const Path& path) {
  for (std::size_t m = path.motionCount(); m-- > 0;) {
    const Point3 way = path.points[path.motionEnd(m)] - path.points[m];
    if (way.norm() > 0.0) return way.normalized();
  }
  return Point3::Zero();
}

void shiftEnd(Path& travel, const NozzlePose& from, const NozzlePose& to) {
  EndShift shift(travel, travel.points.back(), from, to);
  std::size_t waypoint = travel.points.size() - 1;
  while (waypoint > 0 && shift.take(waypoint)) --waypoint;
}

void shiftStart(Path& travel, const NozzlePose& from, const NozzlePose& to) {
  EndShift shift(travel, travel.points.front(), from, to);
  std::size_t waypoint = 0;
  while (waypoint + 1 < travel.points.size() && shift.take(waypoint)) ++waypoint;
}

}  // namespace lamina
