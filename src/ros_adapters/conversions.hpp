// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Quaternion.h>
#include <sensor_msgs/JointState.h>

#include <Eigen/Geometry>
#include <string>

#include "lamina/job/slice_summary.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "messages.hpp"

namespace lamina {

// The only place where the core's millimetres are converted to the messages' metres and back. `toMessage` and
// `fromMessage` are inverse to each other within rounding (1e-12 of the value).

inline constexpr double kMetresPerMillimetre = 1e-3;
inline constexpr double kMillimetresPerMetre = 1e3;

/// Length [m] of a length [mm]; the same for speeds.
inline double toMetres(double millimetres) { return millimetres * kMetresPerMillimetre; }
/// Length [mm] of a length [m]; the same for speeds.
inline double toMillimetres(double metres) { return metres * kMillimetresPerMetre; }

/// Volume [m³] of a volume [mm³]; the same for flows.
inline double toCubicMetres(double cubic_millimetres) { return cubic_millimetres * 1e-9; }
/// Volume [mm³] of a volume [m³]; the same for flows.
inline double toCubicMillimetres(double cubic_metres) { return cubic_metres * 1e9; }
/// Stress or modulus [Pa] of a stress or modulus [MPa].
inline double toPascals(double megapascals) { return megapascals * 1e6; }

geometry_msgs::Point toMessage(const Point3& point);
Point3 fromMessage(const geometry_msgs::Point& point);

geometry_msgs::Quaternion toMessage(const Eigen::Quaterniond& rotation);
Eigen::Quaterniond fromMessage(const geometry_msgs::Quaternion& rotation);

/// @param pose  translation [mm]
geometry_msgs::Pose toMessage(const Eigen::Isometry3d& pose);
/// @throws InvalidInput if the orientation is no unit quaternion or the position is not finite
Eigen::Isometry3d fromMessage(const geometry_msgs::Pose& pose);

lamina_msgs::Bead toMessage(const Bead& bead);
Bead fromMessage(const lamina_msgs::Bead& bead);

/// The message of a summary. Of the times only the estimated and the total time are included; the memory is
/// not.
lamina_msgs::SliceSummary toMessage(const SliceSummary& summary);

/// Axis positions as a message [m], without time stamp.
sensor_msgs::JointState jointState(const CartesianMachine& machine, const AxisValues& values_mm);

/// A toolpath with its identity, its position and its machine, as sent in one message.
struct MachineToolpath {
  std::string id;       ///< id of the toolpath as planned
  std::string machine;  ///< name of the machine for which it was planned
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< translation [mm]
  Toolpath toolpath;
};

/// The message of a toolpath, with an empty header: time stamp and frame are set by the publisher.
lamina_msgs::Toolpath toMessage(const MachineToolpath& placed);
/// The message of a toolpath with the header with which it is published: the part frame, and a time stamp.
lamina_msgs::Toolpath stamped(const MachineToolpath& placed, const ros::Time& stamp);
/// The toolpath of a message. The id is that of the message, as values are rounded by the conversion from
/// metres.
/// @throws InvalidInput if the toolpath does not satisfy `validate`, has an unknown role, or its pose is
///   invalid
MachineToolpath fromMessage(const lamina_msgs::Toolpath& message);

/// Refuses a toolpath that was planned for another machine.
/// @throws InvalidInput unless the toolpath's machine has that name, or the toolpath names none
void requirePlannedFor(const MachineToolpath& placed, const std::string& machine);

/// Refuses a toolpath that the machine cannot run.
/// @throws InvalidInput as `requirePlannedFor`
/// @throws Unreachable naming the first waypoint out of reach
void requireRunsOn(const MachineToolpath& placed, const CartesianMachine& machine);

}  // namespace lamina
