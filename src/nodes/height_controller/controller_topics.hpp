// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <cstddef>
#include <string>

#include "lamina/control/run/loop_run.hpp"
#include "messages.hpp"

namespace lamina {

/// Publishes the output of the loop.
///
/// correction (lamina/CorrectionMap), replanned_toolpath (lamina/Toolpath), loop_state (lamina/LoopState),
/// loop_figures (lamina/LoopFigures), loop_cells and gain_map (sensor_msgs/PointCloud2 of the latest layer),
/// deviation_markers (visualization_msgs/MarkerArray of all layers, one after the other), all latched; the
/// last three in frame `bed`
class ControllerTopics {
 public:
  explicit ControllerTopics(ros::NodeHandle node);

  /// @return the digest of the map as it is published
  std::string publish(const CorrectionMap& map);
  void publish(const PrintPlan& plan);
  void publish(const lamina_msgs::LoopFigures& figures);
  /// An unchanged state is not published again.
  void publish(const lamina_msgs::LoopState& state);
  /// @param layers_below  as of `deviationMarkers`
  void publishCells(const LayerOutcome& layer, std::size_t layers_below,
                    const Eigen::Isometry3d& bed_from_part);
  /// A new print begins: what is shown of the one before is to go.
  void clearCells();

 private:
  ros::Publisher correction_;
  ros::Publisher plan_;
  ros::Publisher state_;
  ros::Publisher figures_;
  ros::Publisher cells_;
  ros::Publisher gains_;
  ros::Publisher beads_;
  lamina_msgs::LoopState last_;
  bool has_state_ = false;
};

}  // namespace lamina
