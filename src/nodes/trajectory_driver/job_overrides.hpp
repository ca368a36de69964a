// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <std_msgs/Float64.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "drive_session.hpp"
#include "messages.hpp"
#include "owner/executor_owner.hpp"

namespace lamina {

/// Changes of feed, flow and power while a job runs: the service change_job, and the topic speed_factor for
/// the feed alone. The last values hold for this job and later ones.
class JobOverrides {
 public:
  /// @param session  the motion under way; null if there is none
  JobOverrides(ros::NodeHandle& node, const TrajectoryFeederSettings& settings, const ExecutorOwner& owner,
               std::function<std::shared_ptr<DriveSession>()> session);

  /// Applies the values set before to a motion that begins.
  void applyTo(DriveSession& session) const;

 private:
  using Change = ros::ServiceEvent<lamina_msgs::ChangeJob::Request, lamina_msgs::ChangeJob::Response>;

  bool onChange(Change& event);
  void change(const std::string& setting, double share);
  void onSpeedFactor(const ros::MessageEvent<const std_msgs::Float64>& event);
  void keep(OverrideKind kind, double share);

  TrajectoryFeederSettings settings_;
  ExecutorOwner owner_;
  std::function<std::shared_ptr<DriveSession>()> session_;
  mutable std::mutex mutex_;
  std::map<OverrideKind, double> shares_;  ///< shares that are not 1
  ros::Subscriber speed_;
  ros::ServiceServer service_;
};

}  // namespace lamina
