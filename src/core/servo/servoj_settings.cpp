// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/servoj_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, ServojSettings& settings) {
  schema.choice("servoj.controller", settings.controller,
                {{"e_series", ServojController::ESeries}, {"cb3", ServojController::Cb3}},
                "Controller of the robot: a target each 2 ms, or each 8 ms.");
  schema.number("servoj.lookahead_s", settings.lookahead_s, {0.03, 0.2},
                "Time over which the robot smooths targets.");
  schema.integer("servoj.gain", settings.gain, {100.0, 2000.0}, "Gain with which the robot follows targets.");
  schema.number(
      "servoj.silence_s", settings.silence_s, {0.008, 60.0},
      "Time without a target after which the robot brakes; up to 0.1 s it goes on as planned, and for "
      "longer it would stand still abruptly.");
  schema.number("servoj.stop_rad_s2", settings.stop_rad_s2, {0.5, 50.0},
                "Deceleration of the fastest joint when the robot brakes by itself.");
}

void describe(SettingsSchema& schema, RobotAddress& settings) {
  schema.text("robot.host", settings.host, "IPv4 address of the robot.");
  schema.integer("robot.script_port", settings.script_port, {1.0, 65535.0},
                 "Port on which the robot takes programs.");
  schema.text("robot.bind", settings.bind,
              "IPv4 address of this host on which the robot's program is awaited.");
  schema.integer("robot.port", settings.port, {0.0, 65535.0}, "Port for that; 0 for any that is free.");
  schema.number("robot.report_silence_s", settings.report_silence_s, {0.02, 60.0},
                "Time without a report of the robot after which it counts as lost.");
}

}  // namespace lamina
