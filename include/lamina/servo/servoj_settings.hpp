// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Controllers of Universal Robots by how often they take a target.
enum class ServojController : std::uint8_t {
  ESeries,  ///< each 2 ms
  Cb3,      ///< each 8 ms
};

/// How a robot of Universal Robots follows targets.
struct ServojSettings {
  ServojController controller = ServojController::ESeries;
  double lookahead_s = 0.1;   ///< over which the robot smooths
  int gain = 300;             ///< with which it follows
  double silence_s = 0.02;    ///< without a target, after which it brakes by itself
  double stop_rad_s2 = 10.0;  ///< deceleration of the fastest joint then

  double cycle() const { return controller == ServojController::ESeries ? 0.002 : 0.008; }
  /// How far ahead the robot is given the plan [s].
  double ahead() const { return silence_s < 0.1 ? silence_s : 0.1; }
};

/// Adds the keys servoj.*.
void describe(SettingsSchema& schema, ServojSettings& settings);

/// Where robot and host meet.
struct RobotAddress {
  std::string host = "127.0.0.1";  ///< of the robot
  int script_port = 30002;         ///< on which it takes programs
  std::string bind = "127.0.0.1";  ///< of this host, on which the robot's program is awaited
  int port = 50002;                ///< for that; 0 for any that is free
  double report_silence_s = 0.1;   ///< without a report of the robot, after which it counts as lost
};

/// Adds the keys robot.*.
void describe(SettingsSchema& schema, RobotAddress& settings);

}  // namespace lamina
