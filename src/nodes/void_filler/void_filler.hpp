// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <mutex>

#include "lamina/job/job_settings.hpp"
#include "messages.hpp"

namespace lamina {

/// Fills the voids of programs between slicing and streaming.
///
/// Services    fill_voids (lamina/FillVoids)
/// Publishes   void_markers (visualization_msgs/MarkerArray, latched): of the last program, its new drops or
///             its voids between beads
///
/// One program at a time: a request during another one is answered with REJECTED. A request that fails
/// publishes and writes nothing.
class VoidFiller {
 public:
  /// @param settings  of every job, as far as its request does not override them
  VoidFiller(ros::NodeHandle node, const JobSettings& settings);
  VoidFiller(const VoidFiller&) = delete;
  VoidFiller& operator=(const VoidFiller&) = delete;

 private:
  bool onService(lamina_msgs::FillVoids::Request& request, lamina_msgs::FillVoids::Response& response);
  lamina_msgs::FillVoids::Response fill(const lamina_msgs::FillVoids::Request& request);

  JobSettings settings_;
  std::mutex job_;
  ros::Publisher markers_;
  ros::ServiceServer service_;
};

}  // namespace lamina
