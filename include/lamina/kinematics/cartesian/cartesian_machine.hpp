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

/// A linear axis.
struct MachineAxis {
  std::string name;                   ///< of the URDF's joint
  Point3 direction = Point3::Zero();  ///< in which the nozzle moves over the bed, of unit length [bed frame]
  double low_mm = 0.0;
  double high_mm = 0.0;
  double max_speed_mm_s = 0.0;
};

/// Whether the axis goes on without end, as that of a belt: its range is 1 km or more.
bool isEndless(const MachineAxis& axis);

/// Values of the machine's axes in the order of `CartesianMachine::axes` [mm].
using AxisValues = Eigen::Vector3d;

/// A machine as its three linear axes move it, its nozzle held at a fixed angle. One with rotary joints,
/// which a `KinematicModel` drives, is the machine with these at zero. Arms and platforms are none.
struct CartesianMachine {
  std::string name;
  std::string urdf;                                                           ///< the text it was made from
  std::array<MachineAxis, 3> axes;                                            ///< x, y, z
  Eigen::Isometry3d bed_from_nozzle_at_zero = Eigen::Isometry3d::Identity();  ///< all axes at 0 [mm]
  Eigen::Isometry3d nozzle_from_sensor =
      Eigen::Isometry3d::Identity();       ///< sensor z is its viewing direction [mm]
  std::vector<std::string> rotary_joints;  ///< held at zero; none where the head is fixed
};

/// Names of the machines with axes x, y and z that come with Lamina (`urdf/`); `kinematicModelNames` has
/// robots too.
std::vector<std::string> machineNames();

/// One of `machineNames`.
/// @throws InvalidConfig if there is none of that name, or it is an arm or platform; names those there are
CartesianMachine machineByName(const std::string& name);

/// Reads a machine from its URDF: prismatic joints x, y and z with limits, links bed, nozzle and sensor, and
/// up to two rotary joints of a, b and c. Lengths in the text are metres, as in every URDF.
/// @throws InvalidConfig if it is no URDF, an arm or platform, one of these is missing, bed or nozzle hang on
/// any other joint
///   that moves, the axes do not span space, or the rotary joints are none that `kinematicModelFromUrdf`
///   takes
CartesianMachine machineFromUrdf(const std::string& text);

/// The build space that its linear axes reach with rotary joints at zero.
BuildSpace buildSpaceOf(const CartesianMachine& machine);

/// Where the nozzle is [mm].
Eigen::Isometry3d bedFromNozzle(const CartesianMachine& machine, const AxisValues& values);

/// Axis values that bring the nozzle tip to a position. The limits are not looked at.
/// @param position  [mm, bed frame]
AxisValues axisValues(const CartesianMachine& machine, const Point3& position);

/// Axis values of positions of the nozzle tip [mm, bed frame]. On a belt printer inclined by a it is a shear:
/// z / sin a goes up the incline, and the belt goes by -y + z cot a, the same for a whole layer.
Eigen::Affine3d axesFromBed(const CartesianMachine& machine);

/// What programs for the machine speak: coordinates of the bed (the identity, to the last bit) where the axes
/// stand at right angles, as firmware counts them whichever of bed and nozzle moves; axis values where they
/// do not, as firmware of belt printers does.
Eigen::Affine3d programFromBed(const CartesianMachine& machine);

}  // namespace lamina
