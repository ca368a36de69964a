// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "part_markers.hpp"

#include <ros/single_subscriber_publisher.h>

#include "latched.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr int kChanges = 100;  // that wait for a subscriber

}  // namespace

PartMarkers::PartMarkers(ros::NodeHandle& node) {
  const ros::SubscriberStatusCallback greet = [this](const ros::SingleSubscriberPublisher& newcomer) {
    welcome(newcomer);
  };
  const std::lock_guard<std::mutex> lock(mutex_);
  publisher_ = node.advertise<visualization_msgs::MarkerArray>(
      names::kPartMarkers, kChanges, greet, ros::SubscriberStatusCallback(), ros::VoidConstPtr(), true);
}

void PartMarkers::begin(const Toolpath& toolpath) {
  const std::lock_guard<std::mutex> lock(mutex_);
  growing_.emplace(toolpath, names::kPartFrame);
}

void PartMarkers::growTo(const WaypointIndex& heading_for) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!growing_) return;
  const visualization_msgs::MarkerArray changed = growing_->upTo(heading_for);
  if (!changed.markers.empty()) publishLatched(publisher_, changed);
}

void PartMarkers::complete() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (growing_) publishLatched(publisher_, growing_->whole());
  growing_.reset();
}

void PartMarkers::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (growing_) publishLatched(publisher_, growing_->soFar());
  growing_.reset();
}

/// What is latched is the last change alone, until the part has ended.
void PartMarkers::welcome(const ros::SingleSubscriberPublisher& newcomer) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (growing_) newcomer.publish(growing_->soFar());
}

}  // namespace lamina
