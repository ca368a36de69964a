// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "controller_topics.hpp"

#include <sensor_msgs/PointCloud2.h>

#include "conversions.hpp"
#include "correction_messages.hpp"
#include "latched.hpp"
#include "loop/loop_messages.hpp"
#include "markers/deviation_markers.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr std::uint32_t kKeepAll = 0;  // bound of a queue: no map is left out

}  // namespace

ControllerTopics::ControllerTopics(ros::NodeHandle node)
    : correction_(node.advertise<lamina_msgs::CorrectionMap>(names::kCorrection, kKeepAll, true)),
      plan_(node.advertise<lamina_msgs::Toolpath>(names::kReplannedToolpath, 1, true)),
      state_(node.advertise<lamina_msgs::LoopState>(names::kLoopState, kKeepAll, true)),
      figures_(node.advertise<lamina_msgs::LoopFigures>(names::kLoopFigures, kKeepAll, true)),
      cells_(node.advertise<sensor_msgs::PointCloud2>(names::kLoopCells, 1, true)),
      gains_(node.advertise<sensor_msgs::PointCloud2>(names::kGainMap, 1, true)),
      beads_(node.advertise<visualization_msgs::MarkerArray>(names::kDeviationMarkers, kKeepAll, true)) {}

std::string ControllerTopics::publish(const CorrectionMap& map) {
  lamina_msgs::CorrectionMap message = toMessage(map);
  message.header.stamp = ros::Time::now();
  publishLatched(correction_, message);
  return message.digest;
}

void ControllerTopics::publish(const PrintPlan& plan) {
  lamina_msgs::Toolpath message = toMessage(
      MachineToolpath{plan.part.toolpath_id, plan.part.machine, plan.part.bed_from_part, plan.part.toolpath});
  message.header.stamp = ros::Time::now();
  message.header.frame_id = names::kPartFrame;
  plan_.publish(message);
}

void ControllerTopics::publish(const lamina_msgs::LoopFigures& figures) {
  lamina_msgs::LoopFigures message = figures;
  message.header.stamp = ros::Time::now();
  publishLatched(figures_, message);
}

void ControllerTopics::publish(const lamina_msgs::LoopState& state) {
  lamina_msgs::LoopState message = state;
  if (has_state_ && message == last_) return;
  last_ = message;
  has_state_ = true;
  message.header.stamp = ros::Time::now();
  publishLatched(state_, message);
}

void ControllerTopics::publishCells(const LayerOutcome& layer, std::size_t layers_below,
                                    const Eigen::Isometry3d& bed_from_part) {
  sensor_msgs::PointCloud2 message = toCloudMessage(layer, bed_from_part);
  message.header.stamp = ros::Time::now();
  message.header.frame_id = names::kBedFrame;
  publishLatched(cells_, message);
  const std_msgs::Header header = message.header;
  message = gainCloudMessage(layer, bed_from_part);
  message.header = header;
  publishLatched(gains_, message);
  publishLatched(beads_, deviationMarkers(layer, layers_below, names::kBedFrame, bed_from_part));
}

void ControllerTopics::clearCells() { publishLatched(beads_, noDeviationMarkers(names::kBedFrame)); }

}  // namespace lamina
