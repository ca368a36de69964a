// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace lamina {

/// What SIGINT, SIGTERM, SIGHUP and `rosnode kill` do to a node.
enum class OnSignal {
  ShutDown,  ///< request a shutdown: `ros::ok()` becomes false, ros::spin() returns
  Request,   ///< nothing but `isStopRequested`: the node still has something to say to others before it goes
};

/// How a node runs.
struct NodeRun {
  std::string name;  ///< under which it joins ROS, remappable
  OnSignal on_signal = OnSignal::ShutDown;
};

/// Whether one of the signals or `rosnode kill` came.
bool isStopRequested();

/// Waits until every message published so far is on its way, then 0.5 s: a subscriber that learns that the
/// node is gone drops what it has not read. A node calls it before its publishers go.
///
/// At most 2 s in all. Does nothing once ROS is shut down.
void awaitDelivery();

/// A node from start to end: joins ROS, on the loopback interface by default (`guardPorts`), loads plug-ins
/// (`loadNodePlugins`), runs `body`, and leaves ROS. On a signal or `rosnode kill` `body` returns or throws,
/// so that destructors run.
///
/// Does not return: the process ends with exit code 0, or 1 if `body` threw; then the message was logged.
[[noreturn]] void runNode(int argc, char** argv, const NodeRun& run, const std::function<void()>& body);

}  // namespace lamina
