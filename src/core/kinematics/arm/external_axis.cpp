// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/arm/external_axis.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/arm/arm_model.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kAlong = 1e-9;  // sine: a tool axis along the axis
constexpr double kBelow = 1e-6;  // mm: axis 1 on the table's axis

/// About which a table turns its bed, and the direction in which it stands.
struct Table {
  Point3 axis = Point3::UnitZ();  ///< of the bed's turn over the base
  Point3 away = Point3::UnitX();
};

Point3 acrossAxis(const Point3& direction, const Point3& axis) {
  return direction - axis.dot(direction) * axis;
}

Table tableOf(const KinematicModel& model) {
  const ArmModel& arm = requireArm(model);
  const SerialChain& chain = arm.chain().external;
  const auto joint = std::find_if(chain.joints.begin(), chain.joints.end(),
                                  [](const DrivenJoint& each) { return each.name == "external_1"; });
  if (joint == chain.joints.end() || joint->kind != JointKind::Rotary)
    throw InvalidConfig("arm '" + arm.name() +
                        "' has no rotary joint external_1; expected a table that turns");
  const Screw& screw = chain.screws[static_cast<std::size_t>(joint - chain.joints.begin())];
  // The screw moves the nozzle over the bed: the bed turns the other way over the base.
  const Point3 axis = -screw.direction;
  const Point3 away = acrossAxis(screw.point - arm.chain().arm.screws[0].point, axis);
  return {axis, away.norm() > kBelow ? away.normalized() : axis.unitOrthogonal()};
}

double azimuthAtZero(const Table& table, const Point3& tool_axis) {
  return std::atan2(table.axis.dot(table.away.cross(tool_axis)), table.away.dot(tool_axis));
}

bool isAlong(const Table& table, const Point3& tool_axis) {
  return acrossAxis(tool_axis, table.axis).norm() < kAlong;
}

}  // namespace

double tableValue(const KinematicModel& arm, const Point3& tool_axis, const TableHeading& heading,
                  double near) {
  const Table table = tableOf(arm);
  if (isAlong(table, tool_axis)) return near;
  const double value = heading.azimuth - azimuthAtZero(table, tool_axis);
  return near + std::remainder(value - near, 2.0 * M_PI);
}

double toolAxisAzimuth(const KinematicModel& arm, const Point3& tool_axis, double table_value) {
  const Table table = tableOf(arm);
  if (isAlong(table, tool_axis)) return 0.0;
  const double azimuth = std::remainder(azimuthAtZero(table, tool_axis) + table_value, 2.0 * M_PI);
  return azimuth <= -M_PI ? azimuth + 2.0 * M_PI : azimuth;
}

}  // namespace lamina
