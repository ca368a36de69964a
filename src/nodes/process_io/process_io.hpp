// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/JointState.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "lamina/base/clock.hpp"
#include "lamina/base/threads/periodic_thread.hpp"
#include "lamina/process_io/devices/device_link.hpp"
#include "lamina/process_io/process_bridge.hpp"
#include "messages.hpp"
#include "node_diagnostics.hpp"
#include "process_io_settings.hpp"

namespace lamina {

/// Sends process values to the devices, in step with the motion. Its topics: docs/nodes/process_io.md.
///
/// Values are computed in a thread of their own; each device is served by another thread.
class ProcessIo {
 public:
  /// @throws InvalidConfig if the tables do not fit
  ProcessIo(ros::NodeHandle node, const ProcessIoSettings& settings);
  /// Sends safe values to all devices, the beam's first, and waits until they are sent.
  ~ProcessIo();

 private:
  void connect(const ros::NodeHandle& node);
  void onTrajectory(const lamina_msgs::ProcessTrajectory& message);
  void onPositions(const sensor_msgs::JointState& message);
  void onCycle(double due_s);
  void sendToDevices(const std::vector<double>& values, double due_s);
  std::vector<double> measuredBy(const std::vector<DeviceReport>& reports) const;
  void publishState();
  void publishReady();
  void publishAlarm(const ProcessAlarm& alarm);
  void tellAlarms(const ros::SingleSubscriberPublisher& subscriber);
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& diagnostics) const;

  SteadyClock clock_;
  ProcessTables tables_;
  ros::Publisher state_;
  ros::Publisher ready_;
  ros::Publisher alarms_;
  std::vector<std::unique_ptr<DeviceLink>> links_;  ///< in the order of the tables
  std::vector<std::size_t> order_;                  ///< order of devices: the beam's first

  mutable std::mutex mutex_;  ///< of what follows up to the subscribers
  ProcessBridge bridge_;
  std::vector<double> measured_;
  std::vector<ProcessAlarm> news_;
  std::vector<std::string> notes_;
  std::string fault_ = "starting";
  double served_s_ = clock_.now();  ///< last cycle

  ros::Subscriber trajectory_;
  ros::Subscriber positions_;
  ros::WallTimer state_timer_;
  ros::WallTimer ready_timer_;
  NodeDiagnostics diagnostics_;
  // Declared last: no cycle runs while the other members are destroyed.
  std::unique_ptr<PeriodicThread> cycle_;
};

}  // namespace lamina
