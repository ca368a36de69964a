// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "process_publisher.hpp"

#include "joint_messages.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr int kQueue = 1000;  // chunks

}  // namespace

ProcessPublisher::ProcessPublisher(ros::NodeHandle& node)
    : publisher_(node.advertise<lamina_msgs::ProcessTrajectory>(names::kProcessTrajectory, kQueue)) {}

void ProcessPublisher::send(const TrajectoryChunk& chunk, const ros::Time& begin,
                            const std::string& toolpath_id, ProcessUse process) {
  const double first_s = chunk.points.front().time_s;
  lamina_msgs::ProcessTrajectory message;
  message.header.stamp = begin + ros::Duration(first_s);
  message.toolpath_id = toolpath_id;
  message.valid_for = ros::Duration(chunk.points.back().time_s - first_s);
  for (const JointState& state : chunk.points) {
    message.points.push_back(toMessage(process == ProcessUse::Off ? safeSignals() : state.process));
    message.points.back().time_from_start = ros::Duration(state.time_s - first_s);
  }
  publisher_.publish(message);
}

void ProcessPublisher::makeSafe(const ros::Time& now) {
  lamina_msgs::ProcessTrajectory message;
  message.header.stamp = now;
  message.points.push_back(toMessage(safeSignals()));
  publisher_.publish(message);
}

}  // namespace lamina
