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

/// Least duration of a motion [s]; also used for a motion in place.
constexpr double kLeastDuration = 1e-3;

/// Length below which a motion counts as in place: it deposits nothing and may take any time [mm].
constexpr double kInPlace = 1e-6;

/// What the joints may do during the motion to a station.
enum class StationWay : std::uint8_t {
  Deposition,   ///< only what the path asks for; also where two paths join
  Travel,       ///< turns of any size, but no change of branch
  ClearTravel,  ///< anything; the motion of a travel on which the nozzle is farthest from the part
};

/// The motion from the station before; without meaning for the first station.
struct StationMotion {
  double length_mm = 0.0;
  double duration_s = kLeastDuration;  ///< at the feed of the motion
  /// Of a clear travel: height of its lowest point above the higher of the travel's two ends.
  double lift_mm = 0.0;
  StationWay way = StationWay::Deposition;
};

/// A pose of the nozzle over the bed that the motion passes.
struct Station {
  Point3 position = Point3::Zero();                                        ///< [mm]
  Eigen::Quaterniond orientation{Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0)};  ///< bed_from_nozzle
  /// Values of external axes, in the order of the kinematic model's joints [mm, rad].
  std::array<double, 3> external{};
  double redundancy = 0.0;  ///< angle of a redundant model [rad]; not wrapped to a turn
  StationMotion motion;

  Eigen::Isometry3d pose() const;
};

/// A toolpath as one motion through stations. Consecutive waypoints with the same pose share a station, as
/// where two paths join.
struct StationList {
  std::vector<Station> stations;
  std::vector<WaypointIndex> waypoints;    ///< in the order of the motion
  std::vector<std::uint32_t> station_of;   ///< index of the station of each waypoint
  std::vector<std::uint32_t> waypoint_of;  ///< index of the first waypoint of each station
};

/// @param tool_offsets_mm  of nozzles from that of the model, by tool [bed frame]: the model's stands so much
///   beside the tip in use
StationList stationsOf(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                       const std::vector<Point3>& tool_offsets_mm);

/// Time at which each station is passed at the feed, from the first one on [s].
std::vector<double> passedAt(const std::vector<Station>& stations);

/// Sets the external axes of stations to the values that the settings ask for: rails to 0 unless the one that
/// carries the arm is moved (arm_rail.hpp), and a table that follows or obeys gravity to the values that the
/// tool axes require. If the tool axis is along an axis of a table, that axis keeps its value. If gravity
/// moves the table and the yaw is free, the nozzle is turned to keep its angle about the tool axis in the
/// room. Does nothing if the kinematic model has no external axes.
/// @throws InvalidConfig if the table is to follow but external_1 is no rotary table; as
///   `gravityTable` and `armRail`
/// @throws Unreachable as `tableValues` and `railValues`
void setExternalAxes(std::vector<Station>& stations, const KinematicModel& model,
                     const JointPathSettings& settings);

}  // namespace lamina
