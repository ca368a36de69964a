// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <functional>
#include <optional>
#include <string>

#include "lamina/base/clock.hpp"

namespace lamina {

/// Takes pictures of a camera as JPEG, at most five a second: compressed images unchanged, raw images
/// encoded.
class CameraIntake {
 public:
  /// @param topic  of raw images; compressed ones are on the topic below it that ends in /compressed
  CameraIntake(ros::NodeHandle node, const std::string& topic, std::function<void(std::string jpeg)> take);

  /// Whether a picture came in the last five seconds.
  bool isThere() const;

 private:
  void onCompressed(const sensor_msgs::CompressedImageConstPtr& image);
  void onRaw(const sensor_msgs::ImageConstPtr& image);
  bool isDue();

  SteadyClock clock_;
  std::function<void(std::string jpeg)> take_;
  ros::Subscriber compressed_;
  ros::Subscriber raw_;
  std::optional<double> taken_s_;             ///< nothing before the first
  std::optional<double> compressed_taken_s_;  ///< of the last compressed picture
};

}  // namespace lamina
