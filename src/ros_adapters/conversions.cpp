// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "conversions.hpp"

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/kinematics/model/toolpath_reach.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr double kUnitTolerance = 1e-6;  // of a quaternion's norm: messages may come from single precision

template <class Message, class Value>
std::vector<Message> toMessages(const std::vector<Value>& values) {
  std::vector<Message> messages;
  messages.reserve(values.size());
  for (const Value& value : values) messages.push_back(toMessage(value));
  return messages;
}

template <class Value, class Message>
std::vector<Value> fromMessages(const std::vector<Message>& messages) {
  std::vector<Value> values;
  values.reserve(messages.size());
  for (const Message& message : messages) values.push_back(fromMessage(message));
  return values;
}

lamina_msgs::ToolpathEvent eventMessage(const PathEvent& placed) {
  using Message = lamina_msgs::ToolpathEvent;
  Message message;
  message.motion = static_cast<std::uint32_t>(placed.motion);
  if (const auto* const dwell = std::get_if<Dwell>(&placed.event)) {
    message.kind = Message::DWELL;
    message.value = dwell->duration_s;
  } else if (const auto* const fan = std::get_if<FanShare>(&placed.event)) {
    message.kind = Message::FAN;
    message.value = fan->share;
  } else if (const auto* const pause = std::get_if<OperatorPause>(&placed.event)) {
    message.kind = Message::PAUSE;
    message.text = pause->message;
  } else if (const auto* const mark = std::get_if<PartMark>(&placed.event)) {
    message.kind = Message::PART;
    message.text = mark->name;
  } else {
    const auto& code = std::get<MachineCode>(placed.event);
    message.kind = code.moves_axes ? Message::MOVING_CODE : Message::CODE;
    message.text = code.text;
  }
  return message;
}

ToolpathEvent fromMessage(const lamina_msgs::ToolpathEvent& message) {
  using Message = lamina_msgs::ToolpathEvent;
  switch (message.kind) {
    case Message::DWELL:
      return Dwell{message.value};
    case Message::FAN:
      return FanShare{message.value};
    case Message::PAUSE:
      return OperatorPause{message.text};
    case Message::PART:
      return PartMark{message.text};
    case Message::CODE:
      return MachineCode{message.text, false};
    case Message::MOVING_CODE:
      return MachineCode{message.text, true};
    default:
      throw InvalidInput("kind of an event is " + std::to_string(message.kind) +
                         "; must be one of lamina/ToolpathEvent");
  }
}

void addProcess(const Path& path, lamina_msgs::ToolpathPath& message) {
  message.tool = path.tool;
  for (const PathEvent& placed : path.events) message.events.push_back(eventMessage(placed));
  for (const ProcessValue& each : path.values) {
    message.values.emplace_back();
    message.values.back().name = each.name;
    message.values.back().value = each.value.values();
  }
}

lamina_msgs::ToolpathPath pathMessage(const Path& path) {
  lamina_msgs::ToolpathPath message;
  message.role = static_cast<std::uint8_t>(path.role);
  message.deposit = static_cast<std::uint8_t>(path.deposit);
  message.is_closed = path.is_closed;
  message.is_retracted = path.process.is_retracted;
  message.points = toMessages<geometry_msgs::Point>(path.points);
  message.orientation = toMessages<geometry_msgs::Quaternion>(path.orientation.values());
  message.bead = toMessages<lamina_msgs::Bead>(path.bead.values());
  for (const double feed : path.feed_mm_s.values()) message.feed.push_back(toMetres(feed));
  addProcess(path, message);
  return message;
}

PathRole roleFromMessage(std::uint8_t role) {
  if (role >= kPathRoles)
    throw InvalidInput("path role is " + std::to_string(role) + "; must be one of lamina/ToolpathPath");
  return static_cast<PathRole>(role);
}

Deposit depositFromMessage(std::uint8_t deposit) {
  if (deposit > lamina_msgs::ToolpathPath::DROPS)
    throw InvalidInput("deposit of a path is " + std::to_string(deposit) +
                       "; must be one of lamina/ToolpathPath");
  return static_cast<Deposit>(deposit);
}

Path fromMessage(const lamina_msgs::ToolpathPath& message) {
  Path path;
  path.role = roleFromMessage(message.role);
  path.deposit = depositFromMessage(message.deposit);
  path.is_closed = message.is_closed;
  path.process.is_retracted = message.is_retracted;
  path.points = fromMessages<Point3>(message.points);
  path.orientation = AlongPath<Eigen::Quaterniond>(fromMessages<Eigen::Quaterniond>(message.orientation));
  path.bead = AlongPath<Bead>(fromMessages<Bead>(message.bead));
  std::vector<double> feed;
  for (const double metres_per_second : message.feed) feed.push_back(toMillimetres(metres_per_second));
  path.feed_mm_s = AlongPath<double>(std::move(feed));
  path.tool = message.tool;
  for (const auto& event : message.events) path.events.push_back({event.motion, fromMessage(event)});
  for (const auto& each : message.values) path.values.push_back({each.name, AlongPath<double>(each.value)});
  return path;
}

lamina_msgs::ToolpathLayer layerMessage(const ToolpathLayer& layer) {
  lamina_msgs::ToolpathLayer message;
  message.z = toMetres(layer.z_mm);
  message.height = toMetres(layer.height_mm);
  message.paths.reserve(layer.paths.size());
  for (const Path& path : layer.paths) message.paths.push_back(pathMessage(path));
  return message;
}

ToolpathLayer fromMessage(const lamina_msgs::ToolpathLayer& message) {
  ToolpathLayer layer;
  layer.z_mm = toMillimetres(message.z);
  layer.height_mm = toMillimetres(message.height);
  layer.paths.reserve(message.paths.size());
  for (const auto& path : message.paths) layer.paths.push_back(fromMessage(path));
  return layer;
}

}  // namespace

geometry_msgs::Point toMessage(const Point3& point) {
  geometry_msgs::Point message;
  message.x = toMetres(point.x());
  message.y = toMetres(point.y());
  message.z = toMetres(point.z());
  return message;
}

Point3 fromMessage(const geometry_msgs::Point& point) {
  return {toMillimetres(point.x), toMillimetres(point.y), toMillimetres(point.z)};
}

geometry_msgs::Quaternion toMessage(const Eigen::Quaterniond& rotation) {
  geometry_msgs::Quaternion message;
  message.x = rotation.x();
  message.y = rotation.y();
  message.z = rotation.z();
  message.w = rotation.w();
  return message;
}

Eigen::Quaterniond fromMessage(const geometry_msgs::Quaternion& rotation) {
  return {rotation.w, rotation.x, rotation.y, rotation.z};
}

geometry_msgs::Pose toMessage(const Eigen::Isometry3d& pose) {
  geometry_msgs::Pose message;
  message.position = toMessage(Point3(pose.translation()));
  message.orientation = toMessage(Eigen::Quaterniond(pose.linear()));
  return message;
}

Eigen::Isometry3d fromMessage(const geometry_msgs::Pose& pose) {
  const Eigen::Quaterniond rotation = fromMessage(pose.orientation);
  const Point3 position = fromMessage(pose.position);
  if (!position.allFinite()) throw InvalidInput("the position of a pose is not finite");
  if (!(std::abs(rotation.norm() - 1.0) < kUnitTolerance))
    throw InvalidInput("the orientation of a pose has norm " + numberText(rotation.norm()) + "; must be 1");
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.linear() = rotation.normalized().toRotationMatrix();
  isometry.translation() = position;
  return isometry;
}

lamina_msgs::Bead toMessage(const Bead& bead) {
  lamina_msgs::Bead message;
  message.width = toMetres(bead.width_mm);
  message.height = toMetres(bead.height_mm);
  return message;
}

Bead fromMessage(const lamina_msgs::Bead& bead) {
  return {toMillimetres(bead.width), toMillimetres(bead.height)};
}

lamina_msgs::SliceSummary toMessage(const SliceSummary& summary) {
  lamina_msgs::SliceSummary message;
  message.mode = summary.mode;
  message.mode_reason = summary.mode_reason;
  message.notes = summary.notes;
  message.steepest_lean = summary.lean.greatest_rad;
  message.steepest_lean_at = toMessage(summary.lean.greatest_at);
  message.overhang_per_layer = toMetres(summary.lean.overhang_mm);
  message.beyond_bead = summary.lean.beyond_bead_mm2 * 1e-6;
  message.triangles = static_cast<std::uint32_t>(summary.triangles);
  message.layers = static_cast<std::uint32_t>(summary.layers);
  message.contours = static_cast<std::uint32_t>(summary.contours);
  message.open_contours = static_cast<std::uint32_t>(summary.open_contours);
  message.deposition_runs = static_cast<std::uint32_t>(summary.deposition_runs);
  message.mesh_volume = toCubicMetres(summary.mesh_volume_mm3);
  message.sliced_volume = toCubicMetres(summary.sliced_volume_mm3);
  message.deposition = toMetres(summary.deposition_mm);
  message.travel = toMetres(summary.travel_mm);
  message.deposited_volume = toCubicMetres(summary.deposited_mm3);
  message.unprinted_volume = toCubicMetres(summary.unprinted_mm3);
  message.refill_runs = static_cast<std::uint32_t>(summary.refilling.runs);
  message.refilled_volume = toCubicMetres(summary.refilling.deposited_mm3);
  message.estimated_time = summary.estimated_time_s;
  message.wall_time = summary.wall_s;
  message.repairs = summary.repairs;
  return message;
}

sensor_msgs::JointState jointState(const CartesianMachine& machine, const AxisValues& values_mm) {
  sensor_msgs::JointState state;
  for (int i = 0; i < 3; ++i) {
    state.name.push_back(machine.axes[static_cast<std::size_t>(i)].name);
    state.position.push_back(toMetres(values_mm[i]));
  }
  for (const std::string& joint : machine.rotary_joints) {
    state.name.push_back(joint);
    state.position.push_back(0.0);
  }
  return state;
}

lamina_msgs::Toolpath toMessage(const MachineToolpath& placed) {
  lamina_msgs::Toolpath message;
  message.id = placed.id;
  message.part_name = placed.toolpath.part_name;
  message.bed_from_part = toMessage(placed.bed_from_part);
  message.part_from_layers = toMessage(placed.toolpath.part_from_layers);
  message.machine = placed.machine;
  message.layers.reserve(placed.toolpath.layers.size());
  for (const ToolpathLayer& layer : placed.toolpath.layers) message.layers.push_back(layerMessage(layer));
  for (const ToolpathEvent& event : placed.toolpath.events_at_end)
    message.events_at_end.push_back(eventMessage({0, event}));
  return message;
}

void requirePlannedFor(const MachineToolpath& placed, const std::string& machine) {
  if (!placed.machine.empty() && placed.machine != machine)
    throw InvalidInput("toolpath is for machine '" + placed.machine + "'; this node has '" + machine + "'");
}

void requireRunsOn(const MachineToolpath& placed, const CartesianMachine& machine) {
  requirePlannedFor(placed, machine.name);
  requireReachable(placed.toolpath, placed.bed_from_part, buildSpaceOf(machine));
}

lamina_msgs::Toolpath stamped(const MachineToolpath& placed, const ros::Time& stamp) {
  lamina_msgs::Toolpath message = toMessage(placed);
  message.header.stamp = stamp;
  message.header.frame_id = names::kPartFrame;
  return message;
}

MachineToolpath fromMessage(const lamina_msgs::Toolpath& message) {
  MachineToolpath placed;
  placed.id = message.id;
  placed.machine = message.machine;
  placed.bed_from_part = fromMessage(message.bed_from_part);
  placed.toolpath.part_name = message.part_name;
  placed.toolpath.part_from_layers = fromMessage(message.part_from_layers);
  placed.toolpath.layers.reserve(message.layers.size());
  for (const auto& layer : message.layers) placed.toolpath.layers.push_back(fromMessage(layer));
  for (const auto& event : message.events_at_end) placed.toolpath.events_at_end.push_back(fromMessage(event));
  validate(placed.toolpath);
  return placed;
}

}  // namespace lamina
