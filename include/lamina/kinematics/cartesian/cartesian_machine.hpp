// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A linear axis of a machine.
struct MachineAxis {
  std::string name;  ///< of the URDF's joint
  /// Direction in which the nozzle moves relative to the bed, of unit length [bed frame].
  Point3 direction = Point3::Zero();
  double low_mm = 0.0;
  double high_mm = 0.0;
  double max_speed_mm_s = 0.0;
};

/// Whether the axis is endless, like that of a belt: its range is 1 km or more.
bool isEndless(const MachineAxis& axis);

/// Values of the machine's axes in the order of `CartesianMachine::axes` [mm].
using AxisValues = Eigen::Vector3d;

/// A machine with three linear axes, its nozzle held at a fixed orientation. Its rotary joints, which a
/// `KinematicModel` drives, are held at zero. Arms and platforms are not represented.
struct CartesianMachine {
  std::string name;
  std::string urdf;                                                           ///< the text it was made from
  std::array<MachineAxis, 3> axes;                                            ///< x, y, z
  Eigen::Isometry3d bed_from_nozzle_at_zero = Eigen::Isometry3d::Identity();  ///< with all axes at 0 [mm]
  /// Z of the sensor is its viewing direction [mm].
  Eigen::Isometry3d nozzle_from_sensor = Eigen::Isometry3d::Identity();
  std::vector<std::string> rotary_joints;  ///< held at zero; empty for a fixed head
};

/// Names of the machines with axes x, y and z that come with Lamina (`urdf/`); `kinematicModelNames` also
/// lists arms and platforms.
std::vector<std::string> machineNames();

/// The machine of one of `machineNames`.
/// @throws InvalidConfig if there is no machine of that name, or it is an arm or platform; lists the
///   available names
CartesianMachine machineByName(const std::string& name);

/// Reads a machine from its URDF: prismatic joints x, y and z with limits, links bed, nozzle and sensor, and
/// up to two rotary joints out of a, b and c. Lengths in the text are metres, as in every URDF.
/// @throws InvalidConfig if it is no URDF, or describes an arm or platform; if one of these joints or links
///   is missing, another moving joint carries bed or nozzle, the axes do not span space, or the rotary joints
///   are not among those that `kinematicModelFromUrdf` supports
CartesianMachine machineFromUrdf(const std::string& text);

/// The build space: what the linear axes reach with rotary joints at zero.
BuildSpace buildSpaceOf(const CartesianMachine& machine);

/// Pose of the nozzle at axis values [mm].
Eigen::Isometry3d bedFromNozzle(const CartesianMachine& machine, const AxisValues& values);

/// Axis values that bring the nozzle tip to a position. Limits are not checked.
/// @param position  [mm, bed frame]
AxisValues axisValues(const CartesianMachine& machine, const Point3& position);

/// The affine map from positions of the nozzle tip [mm, bed frame] to axis values. On a belt printer inclined
/// by a it is a shear: the nozzle moves z / sin a up the incline, and the belt moves by -y + z cot a, which
/// is the same for a whole layer.
Eigen::Affine3d axesFromBed(const CartesianMachine& machine);

/// The affine map from the bed frame to the coordinates of programs. It is exactly the identity if the axes
/// are at right angles: firmware then counts in coordinates of the bed, whether the bed or the nozzle moves.
/// Otherwise the map gives axis values, which firmware of belt printers expects.
Eigen::Affine3d programFromBed(const CartesianMachine& machine);

}  // namespace lamina
