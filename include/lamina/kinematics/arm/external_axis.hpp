// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Where an arm wants tool axes to lean that a table turns for it ([Flores2018, section 6.1.2]: the work
/// object keeps a fixed relation to the head's best heading).
struct TableHeading {
  /// In which direction tool axes go, about the table's axis, from the direction in which the table stands
  /// seen from axis 1; 0 is away from the robot [rad].
  double azimuth = 0.0;
};

/// Value of the joint external_1 of an arm whose bed it turns, with which a tool axis goes at the azimuth
/// wanted over the robot's base: all tool axes of a part whose walls lean outwards then lean alike, and the
/// arm keeps its best posture.
/// @param tool_axis  of unit length [bed frame]
/// @param near  the value is the one nearest to this [rad]; a tool axis along the table's axis keeps it
/// @throws InvalidConfig if the kinematic model is no six-axis arm, or has no rotary joint external_1 under
/// its bed
double tableValue(const KinematicModel& arm, const Point3& tool_axis, const TableHeading& heading,
                  double near);

/// The azimuth of a tool axis over the robot's base, as in `TableHeading` [rad], in (-pi, pi]; 0 along the
/// axis.
/// @throws InvalidConfig as above
double toolAxisAzimuth(const KinematicModel& arm, const Point3& tool_axis, double table_value);

}  // namespace lamina
