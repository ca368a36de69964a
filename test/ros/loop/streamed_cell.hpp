// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

#include "conversions.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "latched.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "point_cloud.hpp"
#include "ros/wait_until.hpp"

namespace lamina::test {

/// A cell of emulated machine, streamer and loop in a namespace of its own, as a client of it sees it.
class StreamedCell {
 public:
  explicit StreamedCell(const std::string& space)
      : node_(space), client_(node_, names::kStreamProgram, false) {
    const boost::function<void(const lamina_msgs::LoopFiguresConstPtr&)> on_layer =
        [this](const auto& layer) { layers.push_back(*layer); };
    const boost::function<void(const lamina_msgs::CorrectionMapConstPtr&)> on_map = [this](const auto& map) {
      maps.push_back(*map);
    };
    const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> on_deposited =
        [this](const auto& cloud) { deposited_ = cloud; };
    layers_ = node_.subscribe<lamina_msgs::LoopFigures>(names::kLoopFigures, 0, on_layer);
    maps_ = node_.subscribe<lamina_msgs::CorrectionMap>(names::kCorrection, 0, on_map);
    surface_ = node_.subscribe<sensor_msgs::PointCloud2>(names::kDeposited, 1, on_deposited);
    toolpath_ = node_.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
  }

  void print(const MachineToolpath& placed) {
    count_ = placed.toolpath.layers.size();
    // Streamer, loop and publisher of tf.
    EXPECT_TRUE(waitUntil([&] { return toolpath_.getNumSubscribers() >= 3 && client_.isServerConnected(); }));
    EXPECT_TRUE(waitUntil([&] { return layers_.getNumPublishers() > 0 && surface_.getNumPublishers() > 0; }));
    publishLatched(toolpath_, toMessage(placed));
    goal_.toolpath_id = placed.id;
    client_.sendGoal(goal_);
  }
  bool hasEnded() {
    return waitUntil([&] { return isOver() && layers.size() == count_; });
  }
  /// Whether the job is over.
  bool isOver() {
    if (!client_.getState().isDone()) return false;
    // The goal may have come ahead of the toolpath.
    const bool was_ahead = client_.getState().getText().find("none was published") != std::string::npos;
    if (was_ahead) client_.sendGoal(goal_);
    return !was_ahead;
  }
  lamina_msgs::Status status() const { return client_.getResult()->status; }

  /// Points of the surface that was published last [mm, frame given by where the bed is in it].
  std::vector<Point3> surface(const Eigen::Isometry3d& frame_from_bed) const {
    return deposited_ ? fromMessage(*deposited_, frame_from_bed).points : std::vector<Point3>();
  }

  std::vector<lamina_msgs::LoopFigures> layers;
  std::vector<lamina_msgs::CorrectionMap> maps;

 private:
  ros::NodeHandle node_;
  actionlib::SimpleActionClient<lamina_msgs::StreamProgramAction> client_;
  lamina_msgs::StreamProgramGoal goal_;
  std::size_t count_ = 0;  ///< of layers
  sensor_msgs::PointCloud2ConstPtr deposited_;
  ros::Subscriber layers_, maps_, surface_;
  ros::Publisher toolpath_;
};

}  // namespace lamina::test
