// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>
#include <vector>

#include "drawing/drawn_part.hpp"
#include "drawing/shown_layers.hpp"

namespace lamina {

/// The layers of one part as markers on a topic (visualization_msgs/MarkerArray): what changes, and to
/// newcomers everything.
class LayerDisplay {
 public:
  explicit LayerDisplay(const std::string& topic);
  LayerDisplay(const LayerDisplay&) = delete;
  LayerDisplay& operator=(const LayerDisplay&) = delete;

  /// All layers of another part; nothing if it has none.
  void show(DrawnPart part);
  /// The first layers of the part.
  void showLayers(std::size_t layers);
  /// Moves the part from where its program puts it [mm].
  void moveTo(const Point3& shift_mm);

  std::size_t layerCount() const { return layers_.layerCount(); }
  /// Of the part where its program puts it [mm]; none if there is none.
  const std::optional<Box3>& box() const { return box_; }

  /// Serves newcomers; returns at once.
  void poll() { queue_.callAvailable(); }

 private:
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ShownLayers layers_;
  std::optional<Box3> box_;
  ros::Publisher publisher_;
};

}  // namespace lamina
