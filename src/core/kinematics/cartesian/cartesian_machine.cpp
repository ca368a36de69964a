// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"

namespace lamina {
namespace {

constexpr double kEndless = 1e6;      // mm
constexpr double kRightAngle = 1e-6;  // rad: digits of a URDF

Eigen::Matrix3d directions(const CartesianMachine& machine) {
  Eigen::Matrix3d columns;
  for (int i = 0; i < 3; ++i) columns.col(i) = machine.axes[static_cast<std::size_t>(i)].direction;
  return columns;
}

}  // namespace

bool isEndless(const MachineAxis& axis) { return axis.high_mm - axis.low_mm >= kEndless; }

BuildSpace buildSpaceOf(const CartesianMachine& machine) {
  const Eigen::Isometry3d& bed_from_nozzle = machine.bed_from_nozzle_at_zero;
  BuildSpace space;
  space.name = machine.name;
  space.bed_from_axes.linear() = directions(machine);
  space.bed_from_axes.translation() = bed_from_nozzle.translation();
  for (std::size_t i = 0; i < 3; ++i) {
    space.range.low[static_cast<Eigen::Index>(i)] = machine.axes[i].low_mm;
    space.range.high[static_cast<Eigen::Index>(i)] = machine.axes[i].high_mm;
    space.is_endless[i] = isEndless(machine.axes[i]);
  }
  space.bed_from_nozzle = bed_from_nozzle.linear();
  space.rotary_joints = machine.rotary_joints;
  space.program_from_bed = programFromBed(machine);
  space.tip_from_sensor = Eigen::Isometry3d(bed_from_nozzle.linear()) * machine.nozzle_from_sensor;
  return space;
}

Eigen::Isometry3d bedFromNozzle(const CartesianMachine& machine, const AxisValues& values) {
  return Eigen::Translation3d(directions(machine) * values) * machine.bed_from_nozzle_at_zero;
}

AxisValues axisValues(const CartesianMachine& machine, const Point3& position) {
  return directions(machine).inverse() * (position - machine.bed_from_nozzle_at_zero.translation());
}

Eigen::Affine3d axesFromBed(const CartesianMachine& machine) {
  Eigen::Affine3d axes = Eigen::Affine3d::Identity();
  axes.linear() = directions(machine).inverse();
  axes.translation() = -axes.linear() * machine.bed_from_nozzle_at_zero.translation();
  return axes;
}

Eigen::Affine3d programFromBed(const CartesianMachine& machine) {
  const Eigen::Matrix3d columns = directions(machine);
  const bool has_right_angles = (columns.transpose() * columns).isIdentity(kRightAngle);
  return has_right_angles ? Eigen::Affine3d::Identity() : axesFromBed(machine);
}

}  // namespace lamina
