// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "kinematics/joint_path/arm_rail.hpp"
#include "kinematics/joint_path/gravity_table.hpp"
#include "kinematics/joint_path/stations.hpp"
#include "kinematics/model/external_joint.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/shortest_rotation.hpp"
#include "lamina/kinematics/arm/external_axis.hpp"

namespace lamina {

namespace {

/// Rails at 0, all that turns at one value.
std::array<double, 3> heldAt(const KinematicModel& model, double value) {
  std::array<double, 3> held{};
  std::size_t next = 0;
  for (const DrivenJoint& joint : model.joints())
    if (isExternal(joint.name)) held.at(next++) = joint.kind == JointKind::Rotary ? value : 0.0;
  return held;
}

void followToolAxes(std::vector<Station>& stations, const KinematicModel& model,
                    const JointPathSettings& settings) {
  const TableHeading heading{settings.external_azimuth_deg * kDegree};
  double value = settings.external_deg * kDegree;
  for (Station& station : stations) {
    value = tableValue(model, station.orientation * Point3::UnitZ(), heading, value);
    station.external[0] = value;
  }
}

/// The nozzle as it would stand in the room without turning about its tool axis: what is free is counted from
/// there, so that it need not turn along with the plate.
Eigen::Quaterniond unspunOver(const GravityTable& table, const TableValues& values, const Point3& tool_axis) {
  const Eigen::Quaterniond turned =
      Eigen::AngleAxisd(values.turn, table.up.axes[0]) * Eigen::AngleAxisd(values.tilt, table.up.axes[1]);
  const Point3 down = -table.up.at_zero;
  const Eigen::Quaterniond upright = shortestRotation(Point3::UnitZ(), down);
  return turned * shortestRotation(down, turned.conjugate() * tool_axis) * upright;
}

void obeyGravity(std::vector<Station>& stations, const KinematicModel& model,
                 const JointPathSettings& settings) {
  const GravityTable table = gravityTable(model);
  const std::vector<TableValues> values =
      tableValues(table, stations, {settings.external_cone_deg * kDegree, settings.external_deg * kDegree});
  for (std::size_t i = 0; i < stations.size(); ++i) {
    stations[i].external.at(table.turn.in_station) = values[i].turn;
    stations[i].external.at(table.tilt.in_station) = values[i].tilt;
    if (settings.yaw == YawChoice::Free)
      stations[i].orientation =
          unspunOver(table, values[i], stations[i].orientation * Point3::UnitZ()).normalized();
  }
}

void moveRail(std::vector<Station>& stations, const KinematicModel& model, RailChoice choice) {
  const ArmRail rail = armRail(model);
  if (choice == RailChoice::Steps && !rail.across.empty())
    throw InvalidConfig("joints.rail is steps, but a gantry of '" + rail.joint + "' and '" +
                        rail.across.front().joint + "' carries '" + rail.arm + "'; expected follow or held");
  for (const CrossRail& across : rail.across) {
    const std::vector<double> values = crossRailValues(rail, across, stations);
    for (std::size_t i = 0; i < stations.size(); ++i) stations[i].external.at(across.in_station) = values[i];
  }
  const std::vector<double> values = railValues(rail, stations, choice);
  for (std::size_t i = 0; i < stations.size(); ++i) stations[i].external.at(rail.in_station) = values[i];
}

/// Who asks for a motion of axes that are not there expects another path than the one without them.
void requireNoExternal(const KinematicModel& model, const JointPathSettings& settings) {
  const bool is_rail_moved = settings.rail != RailChoice::Held;
  if (!is_rail_moved && settings.external == ExternalChoice::Held) return;
  throw InvalidConfig(std::string(is_rail_moved ? "joints.rail" : "joints.external") + " is not held, but '" +
                      model.name() + "' has no external axes; expected held");
}

}  // namespace

void setExternalAxes(std::vector<Station>& stations, const KinematicModel& model,
                     const JointPathSettings& settings) {
  const auto& joints = model.joints();
  const bool has_external = std::any_of(joints.begin(), joints.end(),
                                        [](const DrivenJoint& joint) { return isExternal(joint.name); });
  if (!has_external) return requireNoExternal(model, settings);
  if (stations.empty()) return;
  const std::array<double, 3> held = heldAt(model, settings.external_deg * kDegree);
  for (Station& station : stations) station.external = held;
  if (settings.external == ExternalChoice::Follow) followToolAxes(stations, model, settings);
  if (settings.external == ExternalChoice::Gravity) obeyGravity(stations, model, settings);
  if (settings.rail != RailChoice::Held) moveRail(stations, model, settings.rail);
}

}  // namespace lamina
