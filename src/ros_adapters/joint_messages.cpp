// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "joint_messages.hpp"

#include <algorithm>
#include <cmath>

#include "conversions.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

double siOf(const DrivenJoint& joint, double value) {
  return joint.kind == JointKind::Linear ? toMetres(value) : value;
}

double ofSi(const DrivenJoint& joint, double value) {
  return joint.kind == JointKind::Linear ? toMillimetres(value) : value;
}

std::vector<double> toSi(const JointValues& values, const std::vector<DrivenJoint>& joints) {
  std::vector<double> si;
  for (std::size_t j = 0; j < joints.size(); ++j)
    si.push_back(siOf(joints[j], values[static_cast<Eigen::Index>(j)]));
  return si;
}

/// Where each joint stands in the names.
std::vector<std::size_t> places(const std::vector<std::string>& names,
                                const std::vector<DrivenJoint>& joints) {
  if (names.size() != joints.size())
    throw InvalidInput("a trajectory of " + std::to_string(names.size()) + " joints; expected " +
                       std::to_string(joints.size()));
  std::vector<std::size_t> found;
  for (const DrivenJoint& joint : joints) {
    const auto name = std::find(names.begin(), names.end(), joint.name);
    if (name == names.end()) throw InvalidInput("a trajectory without joint '" + joint.name + "'");
    found.push_back(static_cast<std::size_t>(name - names.begin()));
  }
  return found;
}

enum class Needed { Yes, No };

JointValues valuesOf(const std::vector<double>& si, const std::vector<std::size_t>& places,
                     const std::vector<DrivenJoint>& joints, Needed needed) {
  JointValues values = JointValues::Zero(static_cast<Eigen::Index>(joints.size()));
  if (si.empty() && needed == Needed::No) return values;
  if (si.size() != joints.size())
    throw InvalidInput("a point of " + std::to_string(si.size()) + " numbers for " +
                       std::to_string(joints.size()) + " joints");
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double value = si[places[j]];
    if (!std::isfinite(value)) throw InvalidInput("joint '" + joints[j].name + "' of a point is not finite");
    values[static_cast<Eigen::Index>(j)] = ofSi(joints[j], value);
  }
  return values;
}

/// SI units in that of a level's name.
double siPer(ProcessLevel level) {
  switch (level) {
    case ProcessLevel::WireSpeed:
      return 1e-3;
    case ProcessLevel::ScrewSpeed:
      return 2.0 * M_PI / 60.0;
    case ProcessLevel::Powder:
    case ProcessLevel::Gas:
      return 1e-3 / 60.0;
    default:  // laser power and fan
      return 1.0;
  }
}

template <class Message>
void fillSignals(const ProcessSignals& signals, Message& message) {
  message.flow = toCubicMetres(signals.flow_mm3_s);
  message.laser = signals.is_laser_on;
  message.wire = signals.is_wire_fed;
  message.powder = signals.is_powder_on;
  message.gas = signals.is_gas_on;
  const auto si = [&signals](ProcessLevel level) { return siPer(level) * signals.levels[level]; };
  message.laser_power = si(ProcessLevel::LaserPower);
  message.wire_speed = si(ProcessLevel::WireSpeed);
  message.screw_speed = si(ProcessLevel::ScrewSpeed);
  message.powder_rate = si(ProcessLevel::Powder);
  message.gas_rate = si(ProcessLevel::Gas);
  message.fan = si(ProcessLevel::Fan);
}

}  // namespace

std::vector<std::string> jointNames(const KinematicModel& model) {
  std::vector<std::string> names;
  for (const DrivenJoint& joint : model.joints()) names.push_back(joint.name);
  return names;
}

trajectory_msgs::JointTrajectoryPoint toMessage(const JointState& state,
                                                const std::vector<DrivenJoint>& joints) {
  trajectory_msgs::JointTrajectoryPoint point;
  point.positions = toSi(state.position, joints);
  point.velocities = toSi(state.velocity, joints);
  point.accelerations = toSi(state.acceleration, joints);
  return point;
}

JointState fromMessage(const trajectory_msgs::JointTrajectoryPoint& point,
                       const std::vector<std::string>& names, const std::vector<DrivenJoint>& joints) {
  const std::vector<std::size_t> at = places(names, joints);
  JointState state;
  state.position = valuesOf(point.positions, at, joints, Needed::Yes);
  state.velocity = valuesOf(point.velocities, at, joints, Needed::No);
  state.acceleration = valuesOf(point.accelerations, at, joints, Needed::No);
  return state;
}

lamina_msgs::ProcessPoint toMessage(const ProcessSignals& signals) {
  lamina_msgs::ProcessPoint point;
  fillSignals(signals, point);
  return point;
}

lamina_msgs::ProcessState toStateMessage(const ProcessSignals& signals) {
  lamina_msgs::ProcessState state;
  fillSignals(signals, state);
  return state;
}

ProcessSignals fromMessage(const lamina_msgs::ProcessPoint& point) {
  ProcessSignals signals;
  signals.flow_mm3_s = toCubicMillimetres(point.flow);
  signals.is_laser_on = point.laser;
  signals.is_wire_fed = point.wire;
  signals.is_powder_on = point.powder;
  signals.is_gas_on = point.gas;
  const auto set = [&signals](ProcessLevel level, double si) { signals.levels[level] = si / siPer(level); };
  set(ProcessLevel::LaserPower, point.laser_power);
  set(ProcessLevel::WireSpeed, point.wire_speed);
  set(ProcessLevel::ScrewSpeed, point.screw_speed);
  set(ProcessLevel::Powder, point.powder_rate);
  set(ProcessLevel::Gas, point.gas_rate);
  set(ProcessLevel::Fan, point.fan);
  return signals;
}

}  // namespace lamina
