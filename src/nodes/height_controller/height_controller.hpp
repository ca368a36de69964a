// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arrival_hold.hpp"
#include "cell_calibrator.hpp"
#include "controller_topics.hpp"
#include "height_controller_settings.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/control/report/loop_record.hpp"
#include "loop/loop_feed.hpp"
#include "loop/part_watch.hpp"
#include "loop_alarms.hpp"
#include "node_diagnostics.hpp"
#include "print_hold.hpp"
#include "print_memory.hpp"

namespace lamina {

/// Corrects the next deposits by measurements.
///
/// Subscribes  profile (sensor_msgs/PointCloud2), toolpath (lamina/Toolpath; a new one begins a new print,
/// one
///             that is delivered again, with the same id and stamp, does not),
///             machine_state (lamina/MachineState), applied_correction (lamina/AppliedCorrection), tf
/// Publishes   correction, loop_state, loop_figures, loop_cells, gain_map, deviation_markers (see
/// ControllerTopics), alarm_reports
///             (lamina/AlarmReport), /diagnostics
/// Services    set_loop (lamina/SetLoop), read_calibration (std_srvs/Trigger), and those of CellCalibrator
/// Calls       pause (std_srvs/Trigger) if an alarm holds the print
/// Requires tf from `bed` to the frame of the clouds and to `nozzle`.
class HeightController {
 public:
  HeightController(ros::NodeHandle node, const HeightControllerSettings& settings);
  /// Saves the report.
  ~HeightController();

 private:
  using TfEvent = ros::MessageEvent<tf2_msgs::TFMessage const>;

  void subscribe(ros::NodeHandle& node);
  void onToolpath(const lamina_msgs::ToolpathConstPtr& message);
  void onCloud(const sensor_msgs::PointCloud2ConstPtr& cloud);
  void onTransforms(const TfEvent& event);
  void onFixedTransforms(const TfEvent& event);
  void onMachineState(const lamina_msgs::MachineStateConstPtr& message);
  void onApplied(const lamina_msgs::AppliedCorrectionConstPtr& message);
  bool onReadCalibration(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onSetLoop(lamina_msgs::SetLoop::Request& request, lamina_msgs::SetLoop::Response& response);
  void onTimer();
  bool isFollowedPlan(const std::string& toolpath_id) const;
  bool isDeliveredAgain(const lamina_msgs::Toolpath& message) const;
  void beginPrint(const lamina_msgs::Toolpath& toolpath);
  void beginAgainIfOver(const lamina_msgs::MachineState& machine);
  void beginNextPart(const lamina_msgs::MachineState& machine);
  bool isWaitingForLast() const;
  void endIfDue();
  void endJob();
  /// @param state  of the machine, in which the job has ended
  void endPrint(std::uint8_t state);
  void know(const LoopRunSettings& settings);
  void recalibrate();
  void publishNews();
  void settleAlarms();
  void report(const PrintPlan& plan);
  void report(const RaisedAlarm& alarm);
  void report(const LayerOutcome& layer);
  void save();
  void saveLearnt();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  HeightControllerSettings settings_;  ///< as stated
  std::vector<std::string> known_;     ///< known values of clock, place and feeder, with their sources
  SteadyClock clock_;
  ControllerTopics topics_;
  LoopAlarms alarms_;
  LoopFeed feed_;
  ArrivalHold hold_;
  PrintHold print_hold_;
  PrintMemory memory_;
  CellCalibrator calibrator_;
  lamina_msgs::ToolpathConstPtr announced_toolpath_;  ///< that of the present print
  lamina_msgs::ToolpathConstPtr delivered_toolpath_;  ///< the last one
  lamina_msgs::ToolpathConstPtr part_toolpath_;       ///< the last one that is no plan
  LoopRecord record_;
  std::size_t layers_below_ = 0;  ///< layers of the print below the present plan of the layers left
  std::map<std::size_t, std::string> digests_;  ///< of the maps published last, by layer
  std::string toolpath_fault_;                  ///< why the last toolpath could not be used
  double last_arrival_s_ = 0.0;
  bool is_quiet_ = true;  ///< everything received was processed
  bool is_saved_ = true;
  bool is_learnt_saved_ = false;  ///< of the print under way
  /// A job that has ended.
  struct EndedJob {
    std::uint8_t state = 0;  ///< of the machine
    double since_s = 0.0;
  };
  std::optional<EndedJob> ended_;  ///< whose last messages may still arrive
  PartWatch parts_;
  NodeDiagnostics diagnostics_;
  ros::Subscriber toolpath_;
  ros::Subscriber profile_;
  ros::Subscriber tf_;
  ros::Subscriber tf_static_;
  ros::Subscriber machine_state_;
  ros::Subscriber applied_;
  ros::ServiceServer set_loop_;
  ros::ServiceServer read_calibration_;
  ros::WallTimer timer_;
};

}  // namespace lamina
