// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>

#include <mutex>
#include <string>
#include <vector>

#include "incliner_settings.hpp"
#include "lamina/base/progress.hpp"
#include "messages.hpp"

namespace lamina {

/// Inclines programs on request, and shows them before and after.
///
/// Services    incline_gcode (lamina/InclineGcode)
/// Actions     incline_gcode (lamina/Incline): the same with progress and cancel; a new goal cancels the one
///             under way
/// Publishes   toolpath (lamina/Toolpath, latched): the inclined program
///             toolpath_markers, source_toolpath_markers (visualization_msgs/MarkerArray, latched): the
///             inclined program and its source, in the frame of the bed
///
/// One program at a time: a request during another one is answered with REJECTED. A request that fails
/// publishes and writes nothing.
class GcodeIncliner {
 public:
  /// @param settings  of every job, as far as its request does not override them
  GcodeIncliner(ros::NodeHandle node, const GcodeInclinerSettings& settings);

 private:
  /// What the service's request and the action's goal have in common, and what their answers have.
  struct Request {
    std::string program;
    std::string output;
    std::vector<lamina_msgs::Setting> settings;
  };
  struct Answer {
    lamina_msgs::Status status;
    std::string output;
    std::string toolpath_id;
    lamina_msgs::InclineSummary summary;
  };

  bool onService(lamina_msgs::InclineGcode::Request& request, lamina_msgs::InclineGcode::Response& response);
  void onGoal(const lamina_msgs::InclineGoalConstPtr& goal);
  Answer answer(const Request& request, Progress& progress);
  Answer incline(const Request& request, Progress& progress);
  void view(const std::string& program, const GcodeInclinerSettings& settings, Answer& answer);
  std::string publish(const std::string& program, const GcodeInclinerSettings& settings,
                      const std::string& output);

  GcodeInclinerSettings settings_;
  std::mutex job_;
  ros::Publisher toolpath_;
  ros::Publisher markers_;
  ros::Publisher source_markers_;
  ros::ServiceServer service_;
  actionlib::SimpleActionServer<lamina_msgs::InclineAction> action_;
};

}  // namespace lamina
