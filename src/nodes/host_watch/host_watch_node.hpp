// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <mutex>
#include <optional>

#include "controller_stop.hpp"
#include "graph_look.hpp"
#include "lamina/cell/host_watch.hpp"
#include "lamina/streaming/guard/streamer_watch.hpp"
#include "machine_alarms.hpp"
#include "messages.hpp"
#include "node_diagnostics.hpp"
#include "peer_link.hpp"
#include "watch_settings.hpp"

namespace lamina {

/// The watch of one host on ROS: publishes its observations, and raises alarms of the unit. Its topics:
/// docs/nodes/host_watch.md.
class HostWatchNode {
 public:
  /// @throws DeviceError if the UDP port or the socket of pulses cannot be opened
  /// @throws InvalidConfig as `peersOf`
  HostWatchNode(ros::NodeHandle node, const HostWatchNodeSettings& settings);

 private:
  void onTick();
  void publish();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& diagnostics);
  void watchMachine();
  void onMachine(const GuardNews& news);
  void greet(const ros::SingleSubscriberPublisher& listener);
  lamina_msgs::AlarmReport reportOf(const HostAlarm& alarm) const;

  HostWatchNodeSettings settings_;
  std::vector<PeerAddress> addresses_;
  std::mutex mutex_;  ///< of the watch and the machine's alarms
  HostWatch watch_;
  MachineAlarms machine_alarms_;
  ros::Publisher alarms_;
  ros::Publisher state_;
  NodeDiagnostics diagnostics_;
  lamina_msgs::HostState published_;
  ros::WallTimer timer_;
  double published_s_ = 0.0;
  GraphLook look_;
  PeerLink link_;
  ControllerStop controllers_;  ///< of the watch's thread
  std::optional<StreamerWatch> machine_;
};

}  // namespace lamina
