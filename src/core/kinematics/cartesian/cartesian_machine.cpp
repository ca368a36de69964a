// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"

#include <cmath>
#include <cstdio>
#include <limits>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr double kToolAxisTolerance = 0.01 * M_PI / 180.0;  // far below what a head is built to
constexpr double kEndless = 1e6;                            // mm
constexpr double kRightAngle = 1e-6;                        // rad: digits of a URDF
constexpr double kLimitTolerance = 1e-6;                    // mm: rounding of transforms

Eigen::Matrix3d directions(const CartesianMachine& machine) {
  Eigen::Matrix3d columns;
  for (int i = 0; i < 3; ++i) columns.col(i) = machine.axes[static_cast<std::size_t>(i)].direction;
  return columns;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

/// Why the values are out of the limits; empty if they are not.
std::string limitFault(const CartesianMachine& machine, const AxisValues& values) {
  for (int i = 0; i < 3; ++i) {
    const MachineAxis& axis = machine.axes[static_cast<std::size_t>(i)];
    const double high_mm = isEndless(axis) ? std::numeric_limits<double>::max() : axis.high_mm;
    if (values[i] >= axis.low_mm - kLimitTolerance && values[i] <= high_mm + kLimitTolerance) continue;
    return "axis " + axis.name + " would be at " + number(values[i]) + " mm; " + machine.name + " reaches " +
           number(axis.low_mm) + " to " + number(axis.high_mm) + " mm";
  }
  return "";
}

/// Why the tool axis is out of reach; empty if it is not.
std::string toolAxisFault(const CartesianMachine& machine, const Point3& tool_axis) {
  const Point3 own = machine.bed_from_nozzle_at_zero.linear().col(2);
  const double angle = std::atan2(own.cross(tool_axis).norm(), own.dot(tool_axis));
  if (angle <= kToolAxisTolerance) return "";
  const std::string turn = "the nozzle would have to turn by " + number(angle * 180.0 / M_PI) + " deg; ";
  if (machine.rotary_joints.empty()) return turn + "the head of " + machine.name + " is fixed";
  return turn + "the linear axes of " + machine.name + " alone hold it as it is with joints " +
         listed(machine.rotary_joints, " and ") + " at zero";
}

enum class Checked { Pose, Tip };

/// Checks the paths of one layer with what it needs once.
class ReachCheck {
 public:
  ReachCheck(const CartesianMachine& machine, const Eigen::Isometry3d& bed_from_part, Checked checked)
      : machine_(machine),
        bed_from_part_(bed_from_part),
        values_from_bed_(directions(machine).inverse()),
        checked_(checked) {}

  std::string fault(const Path& path, std::size_t waypoint) const {
    const Point3 position = bed_from_part_ * path.points[waypoint];
    const AxisValues values = values_from_bed_ * (position - machine_.bed_from_nozzle_at_zero.translation());
    std::string found = limitFault(machine_, values);
    if (checked_ == Checked::Pose && found.empty() && (waypoint == 0 || !path.orientation.isCommon()))
      found = toolAxisFault(machine_,
                            bed_from_part_.linear() * (path.orientation.at(waypoint) * Point3::UnitZ()));
    return found;
  }

 private:
  const CartesianMachine& machine_;
  const Eigen::Isometry3d& bed_from_part_;
  Eigen::Matrix3d values_from_bed_;
  Checked checked_;
};

std::string firstFault(const ToolpathLayer& layer, const ReachCheck& check) {
  for (std::size_t p = 0; p < layer.paths.size(); ++p) {
    const Path& path = layer.paths[p];
    for (std::size_t w = 0; w < path.points.size(); ++w) {
      const std::string fault = check.fault(path, w);
      if (!fault.empty())
        return "path " + std::to_string(p) + ", waypoint " + std::to_string(w) + ": " + fault;
    }
  }
  return "";
}

/// @throws Unreachable with the first fault
void requireNoFault(const Toolpath& toolpath, const ReachCheck& check) {
  std::vector<std::string> faults(toolpath.layers.size());
  NoProgress nobody;
  parallelFor(
      faults.size(), [&](std::size_t l) { faults[l] = firstFault(toolpath.layers[l], check); }, nobody,
      "check");
  for (std::size_t l = 0; l < faults.size(); ++l)
    if (!faults[l].empty()) throw Unreachable("layer " + std::to_string(l) + ", " + faults[l]);
}

}  // namespace

bool isEndless(const MachineAxis& axis) { return axis.high_mm - axis.low_mm >= kEndless; }

CartesianMachine withUprightHead(CartesianMachine machine) {
  const Eigen::Isometry3d bed_from_sensor = machine.bed_from_nozzle_at_zero * machine.nozzle_from_sensor;
  machine.bed_from_nozzle_at_zero.linear() = nozzleDown().toRotationMatrix();
  machine.nozzle_from_sensor = machine.bed_from_nozzle_at_zero.inverse() * bed_from_sensor;
  return machine;
}

Box3 workspace(const CartesianMachine& machine) {
  Box3 box;
  for (int corner = 0; corner < 8; ++corner) {
    AxisValues values;
    for (int i = 0; i < 3; ++i) {
      const MachineAxis& axis = machine.axes[static_cast<std::size_t>(i)];
      values[i] = (corner >> i & 1) != 0 ? axis.high_mm : axis.low_mm;
    }
    box.include(bedFromNozzle(machine, values).translation());
  }
  return box;
}

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

Point2 sensorOffset(const CartesianMachine& machine) {
  const Eigen::Matrix3d bed_from_nozzle = machine.bed_from_nozzle_at_zero.linear();
  const Point3 position = bed_from_nozzle * machine.nozzle_from_sensor.translation();
  const Point3 view = bed_from_nozzle * machine.nozzle_from_sensor.linear().col(2);
  if (!(view.z() < 0.0)) throw InvalidConfig("sensor of machine " + machine.name + " does not look down");
  return (position - view * (position.z() / view.z())).head<2>();
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

AxisValues axisValuesWithin(const CartesianMachine& machine, const Eigen::Isometry3d& bed_from_nozzle) {
  const std::string turned = toolAxisFault(machine, bed_from_nozzle.linear().col(2));
  if (!turned.empty()) throw Unreachable(turned);
  AxisValues values = axisValues(machine, bed_from_nozzle.translation());
  const std::string outside = limitFault(machine, values);
  if (!outside.empty()) throw Unreachable(outside);
  return values;
}

void requireReachable(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                      const CartesianMachine& machine) {
  requireNoFault(toolpath, ReachCheck(machine, bed_from_part, Checked::Pose));
}

double greatestToolAxisTurn(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                            const CartesianMachine& machine) {
  const Point3 own = bed_from_part.linear().transpose() * machine.bed_from_nozzle_at_zero.linear().col(2);
  double greatest = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (const Eigen::Quaterniond& orientation : path.orientation.values()) {
        const Point3 tool_axis = orientation * Point3::UnitZ();
        greatest = std::max(greatest, std::atan2(own.cross(tool_axis).norm(), own.dot(tool_axis)));
      }
  return greatest;
}

void requireTipsReachable(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                          const CartesianMachine& machine) {
  requireNoFault(toolpath, ReachCheck(machine, bed_from_part, Checked::Tip));
}

}  // namespace lamina
