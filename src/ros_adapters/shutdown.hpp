// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace lamina {

/// Effect of SIGINT, SIGTERM, SIGHUP and `rosnode kill` on a node.
enum class OnSignal {
  ShutDown,  ///< ROS shuts down: `ros::ok()` becomes false, ros::spin() returns
  Request,   ///< only `isStopRequested` becomes true, as the node still has messages to send before it ends
};

/// Name of a node, and how it reacts to signals.
struct NodeRun {
  std::string name;  ///< name in ROS, remappable
  OnSignal on_signal = OnSignal::ShutDown;
};

/// Whether SIGINT, SIGTERM, SIGHUP or `rosnode kill` was received.
bool isStopRequested();

/// Waits until every message published so far is sent, and then 0.5 s, because a subscriber that learns of
/// the node's end drops messages that it has not read. To be called before the publishers are destroyed.
///
/// Takes at most 2 s. Does nothing once ROS is shut down.
void awaitDelivery();

/// Runs a node from start to end: joins ROS, by default on the loopback interface (`guardPorts`), loads
/// plug-ins (`loadNodePlugins`), runs `body`, and leaves ROS. On a signal or `rosnode kill`, `body` must
/// return or throw, so that destructors run.
///
/// Does not return: the process ends with exit code 0, or with 1, after logging the message, if `body` threw.
[[noreturn]] void runNode(int argc, char** argv, const NodeRun& run, const std::function<void()>& body);

}  // namespace lamina
