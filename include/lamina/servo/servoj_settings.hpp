// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Controllers of Universal Robots, by the duration of their cycle.
enum class ServojController : std::uint8_t {
  ESeries,  ///< 2 ms
  Cb3,      ///< 8 ms
};

/// How a robot of Universal Robots follows targets.
struct ServojSettings {
  ServojController controller = ServojController::ESeries;
  double lookahead_s = 0.1;   ///< `lookahead_time` of servoj, over which the robot smooths
  int gain = 300;             ///< `gain` of servoj
  double silence_s = 0.02;    ///< time without a target after which the robot brakes by itself
  double stop_rad_s2 = 10.0;  ///< deceleration of the fastest joint when it brakes by itself

  /// Duration of a cycle [s].
  double cycle() const { return controller == ServojController::ESeries ? 0.002 : 0.008; }
  /// Time by which `CyclicTarget::ahead` is ahead [s].
  double ahead() const { return silence_s < 0.1 ? silence_s : 0.1; }
};

/// Adds the keys servoj.*.
void describe(SettingsSchema& schema, ServojSettings& settings);

/// Addresses by which robot and host connect to each other.
struct RobotAddress {
  std::string host = "127.0.0.1";  ///< IPv4 address of the robot
  int script_port = 30002;         ///< TCP port at which the robot accepts programs
  std::string bind = "127.0.0.1";  ///< IPv4 address of this host, to which the robot's program connects
  int port = 50002;                ///< TCP port of this host for the robot's program; 0 for any free one
  double report_silence_s = 0.1;   ///< time without a report after which the robot counts as lost
};

/// Adds the keys robot.*.
void describe(SettingsSchema& schema, RobotAddress& settings);

}  // namespace lamina
