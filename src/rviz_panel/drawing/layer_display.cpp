// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/layer_display.hpp"

#include <ros/single_subscriber_publisher.h>

#include <utility>

#include "conversions.hpp"

namespace lamina {

LayerDisplay::LayerDisplay(const std::string& topic) {
  node_.setCallbackQueue(&queue_);
  const auto greet = [this](const ros::SingleSubscriberPublisher& newcomer) {
    newcomer.publish(layers_.all());
  };
  publisher_ = node_.advertise<visualization_msgs::MarkerArray>(topic, 10, greet);
}

void LayerDisplay::show(DrawnPart part) {
  box_.reset();
  if (part.layers > 0) box_ = part.box;
  layers_.load(std::move(part.chunks), part.layers);
  publisher_.publish(layers_.all());
}

void LayerDisplay::moveTo(const Point3& shift_mm) {
  layers_.moveTo(toMessage(shift_mm));
  publisher_.publish(layers_.all());
}

void LayerDisplay::showLayers(std::size_t layers) {
  const visualization_msgs::MarkerArray changes = layers_.show(layers);
  if (!changes.markers.empty()) publisher_.publish(changes);
}

}  // namespace lamina
