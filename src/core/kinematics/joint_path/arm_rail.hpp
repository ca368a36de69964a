// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kinematics/joint_path/stations.hpp"
#include "kinematics/model/joint_ranges.hpp"
#include "kinematics/model/serial_chain.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Another linear axis of a gantry, across its rail: a bridge, or the trolley on it.
struct CrossRail {
  std::string joint;
  std::size_t in_station = 0;  ///< index among the external axes of a station
  JointRange range;
  double aside = 1.0;  ///< displacement of the arm across the rail per millimetre of the axis
};

/// A rail that carries a six-axis arm, and the arm's reach. The wrist is where axis 6 passes axis 5; the
/// shoulder is where axis 2 is with axis 1 turned to the wrist.
struct ArmRail {
  std::string arm;             ///< name of the kinematic model
  std::string joint;           ///< name of the rail
  std::size_t in_station = 0;  ///< index among the external axes of a station
  JointRange range;
  SerialChain external;                          ///< chain of the external axes
  std::vector<std::size_t> external_in_station;  ///< index of each of its joints among those of a station
  Eigen::Index in_external = 0;                  ///< index of the rail in that chain

  Point3 centre =
      Point3::Zero();           ///< on axis 1 at the shoulder, with all external axes at zero [mm, bed frame]
  Point3 up = Point3::UnitZ();  ///< along axis 1
  Point3 along = Point3::UnitX();  ///< direction of the arm as the rail's value grows
  double shoulder_mm = 0.0;        ///< distance of the shoulder from axis 1
  double reach_mm = 0.0;           ///< distance of the wrist from the shoulder with the elbow straight
  double wrist_mm = 0.0;           ///< height of the wrist over the tip, along the tool axis
  std::vector<CrossRail> across;   ///< other axes of a gantry
  double slack_mm = 0.0;           ///< greatest distance of the wrist from its assumed point on the tool axis
};

/// The rail of a kinematic model, the longest axis of a gantry. Axes of a gantry along axis 1 are not rails:
/// they are held.
/// @throws InvalidConfig naming the arm if it is no six-axis arm, or no linear external axis is at a right
///   angle to axis 1, within 1 deg; if a linear external axis has another direction, except along axis 1 on a
///   gantry, or carries a rotary one; or if two run the same way
ArmRail armRail(const KinematicModel& model);

/// Values of a rail [mm], for each station, with which the wrist is between 0.35 and 0.9 of the reach from
/// the shoulder wherever the limits allow it. If both sides of the wrist allow it, the arm stands behind the
/// wrist. `RailChoice::Follow` moves the rail like a taut string over the durations through the values that
/// are allowed, from 0.7 of the reach on, with its corners rounded over 0.4 s. `RailChoice::Steps` moves it
/// on travels alone, as rarely as possible, to where the mean distance is nearest to 0.7 of the reach; up to
/// 0.97 of the reach is allowed for beads that are not reached otherwise.
/// @param stations  with the values of all other external axes
/// @throws Unreachable naming the rail if its limits keep the arm from a station, or if it would have to move
///   along a bead in steps
std::vector<double> railValues(const ArmRail& rail, const std::vector<Station>& stations, RailChoice choice);

/// Values of an axis across the rail [mm], for each station, with which the wrist is at most 0.3 of the reach
/// aside of where the rail carries the arm, wherever the limits allow it: as for a rail that follows, from
/// where the arm is level with the wrist.
/// @param stations  with the values of all other external axes but the rail's
std::vector<double> crossRailValues(const ArmRail& rail, const CrossRail& across,
                                    const std::vector<Station>& stations);

}  // namespace lamina
