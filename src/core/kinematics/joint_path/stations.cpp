// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/stations.hpp"

#include <algorithm>
#include <utility>

namespace lamina {

namespace {

constexpr double kSamePosition = 1e-9;  // mm
constexpr double kSameTurn = 1e-24;     // 1 - cos², of half the angle: far below what joints resolve
constexpr double kLiftStep = 1e-3;      // mm: lesser differences of height are none

/// Which motion of a travel is furthest from the part, and how far.
struct ClearMotion {
  std::size_t motion = 0;
  double lift_mm = 0.0;
};

/// The highest motion of a travel, of these the longest; heights are along the tool axis, from the part away.
ClearMotion clearMotion(const Path& path) {
  const Point3 up = -(path.orientation.at(0) * Point3::UnitZ());
  const double ground = std::max(up.dot(path.firstPoint()), up.dot(path.lastPoint()));
  ClearMotion best;
  std::pair<double, double> best_rank{-1.0, -1.0};
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const Point3& from = path.points[m];
    const Point3& to = path.points[path.motionEnd(m)];
    const double lift = std::max(0.0, std::min(up.dot(from), up.dot(to)) - ground);
    const std::pair<double, double> rank{std::floor(lift / kLiftStep), (to - from).norm()};
    if (rank <= best_rank) continue;
    best_rank = rank;
    best = {m, rank.first * kLiftStep};
  }
  return best;
}

class StationBuilder {
 public:
  StationBuilder(const Eigen::Isometry3d& bed_from_part, const std::vector<Point3>& tool_offsets_mm)
      : bed_from_part_(bed_from_part), turn_(bed_from_part.linear()), offsets_(tool_offsets_mm) {}

  void add(const Path& path, WaypointIndex at) {
    const ClearMotion clear = path.role == PathRole::Travel ? clearMotion(path) : ClearMotion();
    at.waypoint = 0;
    add(path, at, {});
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      at.waypoint = path.motionEnd(m);
      StationMotion motion;
      motion.length_mm = (path.points[at.waypoint] - path.points[m]).norm();
      motion.duration_s = motion.length_mm / path.feed_mm_s.at(at.waypoint);
      if (path.role == PathRole::Travel)
        motion.way = m == clear.motion ? StationWay::ClearTravel : StationWay::Travel;
      if (motion.way == StationWay::ClearTravel) motion.lift_mm = clear.lift_mm;
      add(path, at, motion);
    }
  }

  StationList take() { return std::move(list_); }

 private:
  void add(const Path& path, const WaypointIndex& at, StationMotion motion) {
    Station station;
    station.position = bed_from_part_ * path.points[at.waypoint];
    if (path.tool < offsets_.size()) station.position -= offsets_[path.tool];
    station.orientation = turn_ * path.orientation.at(at.waypoint);
    motion.duration_s = std::max(motion.duration_s, kLeastDuration);
    station.motion = motion;
    if (list_.stations.empty() || !isAtLast(station)) {
      list_.waypoint_of.push_back(static_cast<std::uint32_t>(list_.waypoints.size()));
      list_.stations.push_back(station);
    }
    list_.station_of.push_back(static_cast<std::uint32_t>(list_.stations.size() - 1));
    list_.waypoints.push_back(at);
  }

  bool isAtLast(const Station& station) const {
    const Station& last = list_.stations.back();
    if ((last.position - station.position).norm() > kSamePosition) return false;
    return (last.orientation.inverse() * station.orientation).vec().squaredNorm() <= kSameTurn;
  }

  Eigen::Isometry3d bed_from_part_;
  Eigen::Quaterniond turn_;
  const std::vector<Point3>& offsets_;
  StationList list_;
};

}  // namespace

Eigen::Isometry3d Station::pose() const {
  Eigen::Isometry3d bed_from_nozzle = Eigen::Isometry3d::Identity();
  bed_from_nozzle.linear() = orientation.toRotationMatrix();
  bed_from_nozzle.translation() = position;
  return bed_from_nozzle;
}

StationList stationsOf(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                       const std::vector<Point3>& tool_offsets_mm) {
  StationBuilder builder(bed_from_part, tool_offsets_mm);
  for (std::size_t layer = 0; layer < toolpath.layers.size(); ++layer)
    for (std::size_t path = 0; path < toolpath.layers[layer].paths.size(); ++path)
      builder.add(toolpath.layers[layer].paths[path], {layer, path, 0});
  return builder.take();
}

std::vector<double> passedAt(const std::vector<Station>& stations) {
  std::vector<double> at(stations.size(), 0.0);
  for (std::size_t i = 1; i < at.size(); ++i) at[i] = at[i - 1] + stations[i].motion.duration_s;
  return at;
}

}  // namespace lamina
