// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Direction in which all tool axes lean while a turntable follows the toolpath. The arm thereby keeps its
/// best posture ([Flores2018, section 6.1.2]: the work object keeps a fixed relation to the head's best
/// heading).
struct TableHeading {
  /// Direction of tool axes about the table's axis [rad]. 0 is the direction from axis 1 of the robot to the
  /// table, away from the robot.
  double azimuth = 0.0;
};

/// Value of the joint external_1, a turntable that carries the bed, at which a tool axis has the wanted
/// azimuth in the robot's base frame. With this value, all tool axes of a part whose walls lean outwards lean
/// in the same direction, and the arm keeps its best posture.
/// @param tool_axis  of unit length [bed frame]
/// @param near  the equivalent value nearest to `near` is returned [rad]; `near` itself if the tool axis is
///   parallel to the table's axis
/// @throws InvalidConfig if the kinematic model is no arm, or has no rotary joint external_1 that
///   carries its bed
double tableValue(const KinematicModel& arm, const Point3& tool_axis, const TableHeading& heading,
                  double near);

/// The azimuth of a tool axis in the robot's base frame, as in `TableHeading` [rad], in (-pi, pi]; 0 if the
/// tool axis is parallel to the table's axis.
/// @param tool_axis    of unit length [bed frame]
/// @param table_value  value of external_1 [rad]
/// @throws InvalidConfig as above
double toolAxisAzimuth(const KinematicModel& arm, const Point3& tool_axis, double table_value);

}  // namespace lamina
