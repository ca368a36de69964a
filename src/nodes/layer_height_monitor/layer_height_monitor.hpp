// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "height_topics.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/calibration/calibration_file.hpp"
#include "lamina/monitoring/stamped_heights.hpp"
#include "loop/part_watch.hpp"
#include "messages.hpp"
#include "monitor_settings.hpp"
#include "node_diagnostics.hpp"
#include "profile_intake.hpp"
#include "silence_watch.hpp"

namespace lamina {

/// Compares measured profiles with the heights that the toolpath should have given.
///
/// Subscribes  profile (sensor_msgs/PointCloud2), toolpath (lamina/Toolpath; a new one starts new maps), tf,
///             machine_state (lamina/MachineState; another part starts new maps)
/// Publishes   measuring, layer_height, height_map, height_deviation (see HeightTopics), /diagnostics
/// Services    save_height_map (std_srvs/Trigger), finish_measuring (lamina/FinishMeasuring)
/// Requires tf from `bed` to the frame of the clouds and to `nozzle`.
class LayerHeightMonitor {
 public:
  LayerHeightMonitor(ros::NodeHandle node, const LayerHeightMonitorSettings& settings);
  /// Saves what was measured.
  ~LayerHeightMonitor();

 private:
  void onToolpath(const lamina_msgs::ToolpathConstPtr& message);
  void onMachineState(const lamina_msgs::MachineStateConstPtr& message);
  void beginPart();
  void onProfile(const PlacedProfile& profile);
  void onNozzle(const StampedNozzle& nozzle);
  void onRestart();
  void onTimer();
  bool onFinish(lamina_msgs::FinishMeasuring::Request& request,
                lamina_msgs::FinishMeasuring::Response& response);
  void finishOnce(const lamina_msgs::FinishMeasuring::Request& request);
  void announce();
  bool onSave(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void report(const LayerHeightReports& layers);
  lamina_msgs::ProfileCounts counts() const;
  void save();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  LayerHeightMonitorSettings settings_;
  SteadyClock clock_;
  HeightTopics topics_;
  std::unique_ptr<StampedHeights> heights_;  ///< empty before the first toolpath
  lamina_msgs::ToolpathConstPtr announced_;  ///< the last toolpath
  PartWatch parts_;                          ///< of it
  std::string toolpath_id_;
  ros::Time toolpath_stamp_;
  std::string toolpath_fault_;  ///< why the last toolpath could not be used
  std::vector<LayerHeightReport> layers_;
  std::uint64_t profiles_without_toolpath_ = 0;
  IntakeCounts before_;  ///< when the toolpath came
  SilenceWatch silence_;
  double last_maps_s_ = -std::numeric_limits<double>::infinity();
  bool is_saved_ = true;
  bool is_announced_ = false;  ///< whether the measurement of the toolpath was announced
  bool is_finished_ = false;   ///< whether the measurement of the toolpath is over
  Calibration calibration_;    ///< empty without a file
  ProfileIntake intake_;
  NodeDiagnostics diagnostics_;
  ros::Subscriber toolpath_;
  ros::Subscriber machine_state_;
  ros::ServiceServer save_;
  ros::ServiceServer finish_;
  ros::WallTimer timer_;
};

}  // namespace lamina
