// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls/opened_loop.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

/// Stretches shorter than this are left out [mm].
constexpr double kShortest = 1e-6;

/// Where the nozzle is and how it is held.
struct Pose {
  Point3 point;
  Eigen::Quaterniond orientation;
};

/// Waypoints of an open path: where each is, and which waypoint of the joined loop describes the way to it.
struct Waypoints {
  std::vector<Point3> points;
  std::vector<Eigen::Quaterniond> orientations;
  std::vector<std::size_t> from;

  void add(const Pose& pose, std::size_t waypoint) {
    if (!points.empty() && (pose.point - points.back()).norm() < kShortest) return;
    points.push_back(pose.point);
    orientations.push_back(pose.orientation);
    from.push_back(waypoint);
  }

  /// Takes away from the end.
  void shorten(double left_out) {
    while (points.size() > 1) {
      const Point3 back = points[points.size() - 2] - points.back();
      const double length = back.norm();
      if (length > left_out + kShortest) {
        points.back() += left_out / length * back;
        orientations.back() =
            orientations.back().slerp(left_out / length, orientations[orientations.size() - 2]);
        return;
      }
      left_out -= length;
      points.pop_back();
      orientations.pop_back();
      from.pop_back();
    }
  }
};

Point3 startOf(const Path& joined_loop, const JoinedLoopPlace& place) {
  const Point3& from = joined_loop.points[place.motion];
  return from + place.part * (joined_loop.points[joined_loop.motionEnd(place.motion)] - from);
}

Pose poseAt(const Path& joined_loop, std::size_t waypoint) {
  return {joined_loop.points[waypoint], joined_loop.orientation.at(waypoint)};
}

Pose startPoseOf(const Path& joined_loop, const JoinedLoopPlace& place) {
  const Eigen::Quaterniond& from = joined_loop.orientation.at(place.motion);
  const Eigen::Quaterniond& to = joined_loop.orientation.at(joined_loop.motionEnd(place.motion));
  return {startOf(joined_loop, place), from.slerp(place.part, to)};
}

}  // namespace

JoinedLoopPlace nearestPlace(const Path& joined_loop, const Point3& point) {
  JoinedLoopPlace best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t motion = 0; motion < joined_loop.motionCount(); ++motion) {
    const Point3& from = joined_loop.points[motion];
    const Point3 along = joined_loop.points[joined_loop.motionEnd(motion)] - from;
    const double squared = along.squaredNorm();
    const double part = squared > 0.0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0.0;
    const Point3 place = from + part * along;
    const double distance = (place - point).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    best = {motion, part, place};
  }
  return best;
}

Path opened(const Path& joined_loop, const LoopOpening& opening) {
  const std::size_t count = joined_loop.points.size();
  const std::size_t motion = opening.start.motion;
  const std::size_t end = joined_loop.motionEnd(motion);
  const Pose start = startPoseOf(joined_loop, opening.start);
  Waypoints waypoints;
  waypoints.add(start, end);
  for (std::size_t i = 0; i < count; ++i) {
    // The way to a waypoint is described by itself forwards, and by the one after it backwards.
    if (opening.sense == LoopSense::AsGiven)
      waypoints.add(poseAt(joined_loop, (end + i) % count), (end + i) % count);
    else
      waypoints.add(poseAt(joined_loop, (motion + count - i) % count), (motion + count - i + 1) % count);
  }
  waypoints.add(start, end);
  waypoints.shorten(opening.left_out_mm);
  Path path = joined_loop;
  path.is_closed = false;
  path.points = std::move(waypoints.points);
  path.bead = picked(joined_loop.bead, waypoints.from);
  path.feed_mm_s = picked(joined_loop.feed_mm_s, waypoints.from);
  if (!joined_loop.orientation.isCommon())
    path.orientation = AlongPath<Eigen::Quaterniond>(std::move(waypoints.orientations));
  return path;
}

Point3 endOfOpened(const Path& joined_loop, const LoopOpening& opening) {
  const std::size_t count = joined_loop.points.size();
  const std::size_t motion = opening.start.motion;
  Point3 end = startOf(joined_loop, opening.start);
  double left_out = opening.left_out_mm;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = opening.sense == LoopSense::AsGiven
                                 ? (motion + count - i) % count
                                 : (joined_loop.motionEnd(motion) + i) % count;
    const Point3 back = joined_loop.points[next] - end;
    const double length = back.norm();
    if (length > left_out) return length > 0.0 ? Point3(end + left_out / length * back) : end;
    left_out -= length;
    end = joined_loop.points[next];
  }
  return end;
}

}  // namespace lamina
