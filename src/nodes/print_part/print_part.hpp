// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <ros/node_handle.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "console_progress.hpp"
#include "print_part_settings.hpp"
#include "print_report.hpp"

namespace lamina {

/// Drives the cell through one part: slices it, streams the program, and waits for the measured heights.
///
/// Action clients   slice (lamina/Slice), stream_program (lamina/StreamProgram)
/// Service clients  finish_measuring (lamina/FinishMeasuring), save_height_map (std_srvs/Trigger),
///                  machine_rest (lamina/MachineRest), if the machine has it
/// Subscribes       toolpath (lamina/Toolpath), measuring (lamina/Measuring), layer_height
///                  (lamina/LayerHeight), tf
class PrintPart {
 public:
  /// Waits for the other nodes.
  /// @throws TimedOut if one of them is not there
  PrintPart(ros::NodeHandle node, PrintPartSettings settings);

  /// A program under way is stopped safely before an exception leaves the function.
  /// @throws Error with the code and message of the node that failed
  /// @throws TimedOut if a node falls silent
  /// @throws Cancelled when the process is asked to stop, or ROS shuts down
  PrintReport run();

 private:
  using Clock = std::chrono::steady_clock;

  void subscribe(ros::NodeHandle& node);
  void onLayer(const lamina_msgs::LayerHeightConstPtr& layer);
  /// Whether a report belongs to this print; reports of an earlier print, also of the same part, do not.
  bool isOfThisPrint(const lamina_msgs::LayerHeight& layer) const;
  /// Waits until the monitor is ready for the toolpath.
  void awaitMeasuring();
  /// Waits until tf has reached the machine's position.
  void awaitFollowing();
  lamina_msgs::SliceResult slice();
  lamina_msgs::StreamProgramResult stream();
  void stopStreaming();
  void awaitHeights();
  bool isMeasured();
  bool askRest();
  bool askFinish(const ros::Time& last_position, const ros::Time& last_profile);
  /// Layers with a scan pass for which no report has come.
  std::vector<std::size_t> unreported() const;
  void saveHeightMap();
  void saveFiles(const PrintReport& report);
  std::string outputFile(const std::string& name) const;
  /// Handles callbacks until `isDone`.
  /// @throws TimedOut if no callback reported progress for `patience_s`
  void await(const std::string& what, const std::function<bool()>& isDone);
  double silence() const;  ///< [s] since the last advance
  void noteAdvance() { last_advance_ = Clock::now(); }

  PrintPartSettings settings_;
  ros::NodeHandle node_;
  ConsoleProgress console_;
  actionlib::SimpleActionClient<lamina_msgs::SliceAction> slice_;
  actionlib::SimpleActionClient<lamina_msgs::StreamProgramAction> stream_;
  ros::ServiceClient save_height_map_;
  ros::ServiceClient finish_measuring_;
  ros::ServiceClient machine_rest_;
  lamina_msgs::ToolpathConstPtr toolpath_;
  lamina_msgs::MeasuringConstPtr measuring_;
  lamina_msgs::MachineRestResponse rest_;        ///< what the machine last answered
  lamina_msgs::FinishMeasuringResponse finish_;  ///< what the monitor last answered
  std::vector<lamina_msgs::LayerHeight> layers_;
  std::vector<std::size_t> scanned_;  ///< layers with a scan pass
  bool has_everything_ = false;       ///< whether the monitor has all up to the machine's last stamp
  ros::Subscriber toolpath_subscriber_;
  ros::Subscriber measuring_subscriber_;
  ros::Subscriber layer_subscriber_;
  Clock::time_point last_advance_ = Clock::now();
};

}  // namespace lamina
