// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <optional>
#include <set>

#include "names.hpp"
#include "ros/wait_until.hpp"

namespace lamina::test {

/// What the loop shows of its cells, as RViz takes it.
class ShownCells {
 public:
  explicit ShownCells(ros::NodeHandle node) {
    using Cloud = sensor_msgs::PointCloud2;
    using Beads = visualization_msgs::MarkerArray;
    const boost::function<void(const Cloud::ConstPtr&)> on_cells = [this](const auto& it) { cells = *it; };
    const boost::function<void(const Cloud::ConstPtr&)> on_gains = [this](const auto& it) { gains = *it; };
    const boost::function<void(const Beads::ConstPtr&)> on_beads = [this](const auto& beads) {
      for (const auto& marker : beads->markers)
        if (marker.action == marker.ADD && marker.ns == "beads") layers_.insert(marker.id);
    };
    cells_ = node.subscribe<Cloud>(names::kLoopCells, 10, on_cells);
    gains_ = node.subscribe<Cloud>(names::kGainMap, 10, on_gains);
    beads_ = node.subscribe<Beads>(names::kDeviationMarkers, 0, on_beads);
    EXPECT_TRUE(waitUntil([this] { return beads_.getNumPublishers() > 0; }));
  }

  /// Whether clouds came, and this many layers as beads.
  bool areAll(std::size_t layers) const { return cells && gains && layers_.size() == layers; }

  /// Numbers of the layers that are shown as beads.
  const std::set<std::int32_t>& layers() const { return layers_; }

  std::optional<sensor_msgs::PointCloud2> cells;
  std::optional<sensor_msgs::PointCloud2> gains;

 private:
  std::set<std::int32_t> layers_;
  ros::Subscriber cells_, gains_, beads_;
};

}  // namespace lamina::test
