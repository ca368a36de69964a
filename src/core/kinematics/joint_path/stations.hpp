// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A motion in place is counted as one of this time [s].
constexpr double kLeastDuration = 1e-3;

/// A motion that is shorter lays nothing, and may take its time [mm].
constexpr double kInPlace = 1e-6;

/// What a kinematic model may do with its joints on the way to a station.
enum class StationWay : std::uint8_t {
  Deposition,   ///< or a join of two paths: only what the path asks for
  Travel,       ///< any turn, but no change of branch
  ClearTravel,  ///< the motion of a travel on which the nozzle is furthest from the part: anything
};

/// The way from the station before; that of the first one has no meaning.
struct StationMotion {
  double length_mm = 0.0;
  double duration_s = kLeastDuration;  ///< at its feed; no less than this
  double lift_mm = 0.0;  ///< of a clear travel: by how much all of it is above both ends of the travel
  StationWay way = StationWay::Deposition;
};

/// A pose of the nozzle over the bed that the motion comes through.
struct Station {
  Point3 position = Point3::Zero();                                        ///< [mm]
  Eigen::Quaterniond orientation{Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0)};  ///< bed_from_nozzle
  /// Values of external axes, in the order of the kinematic model's joints [mm, rad].
  std::array<double, 3> external{};
  StationMotion motion;

  Eigen::Isometry3d pose() const;
};

/// A toolpath as one motion through stations. Waypoints that follow each other at one pose, as where paths
/// join, share a station.
struct StationList {
  std::vector<Station> stations;
  std::vector<WaypointIndex> waypoints;    ///< in the order of the motion
  std::vector<std::uint32_t> station_of;   ///< as many as waypoints: index of its station
  std::vector<std::uint32_t> waypoint_of;  ///< as many as stations: index of its first waypoint
};

StationList stationsOf(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part);

/// Puts external axes to the values that the settings ask for: rails to 0, a table that follows or obeys
/// gravity to where the tool axes want it. A tool axis along the axis of a table leaves that axis as it was.
/// Where gravity leads a table and the yaw is free, the nozzle then stands as it would in the room without
/// turning about its tool axis. Does nothing on kinematic models without external axes.
/// @throws InvalidConfig if the table is to follow, and external_1 is no table that turns; as `gravityTable`
/// @throws Unreachable as `tableValues`
void setExternalAxes(std::vector<Station>& stations, const KinematicModel& model,
                     const JointPathSettings& settings);

}  // namespace lamina
