// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>

#include "drawn_part.hpp"
#include "shown_layers.hpp"

namespace lamina {

/// The original and the inclined part side by side as markers. The original stands where its program puts it;
/// once there is an inclined part it moves beside that, towards -y, for the two would stand in each other.
///
/// Publishes `source_layers`, `inclined_layers` (visualization_msgs/MarkerArray): what changes, and to
/// newcomers everything
class PartView {
 public:
  /// @param frame  of both programs' coordinates
  explicit PartView(std::string frame);

  void showSource(DrawnPart part);
  void showInclined(DrawnPart part);
  void removeInclined();
  /// Shows the first layers of both.
  void showLayers(std::size_t layers);
  /// Of the part with more of them.
  std::size_t layerCount() const;
  /// Of what is shown, as it stands in the frame [mm]; none if nothing is.
  std::optional<Box3> box() const;

  /// Serves newcomers; returns at once.
  void poll() { queue_.callAvailable(); }

 private:
  /// One of the two parts.
  struct Side {
    ShownLayers layers;
    std::optional<Box3> box;
    ros::Publisher publisher;
  };

  ros::Publisher advertise(const std::string& topic, const Side& side);
  static void load(Side& side, DrawnPart part);
  Point3 sourceShift() const;
  void standApart();

  std::string frame_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  Side source_;
  Side inclined_;
};

}  // namespace lamina
