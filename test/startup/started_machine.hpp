// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/startup/startup.hpp"
#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"
#include "startup/large_gantry.hpp"

namespace lamina::test {

/// The start-up of the large gantry, with what a machine in order would say to it.
class StartedMachine {
 public:
  explicit StartedMachine(const StartupSettings& settings = largeGantry()) : startup(settings) {}

  void say(const std::string& line) { startup.onReply(parseReply(line), now_s); }
  void sayBed(double bed_c) { say("T:25.00 /0.00 B:" + std::to_string(bed_c) + " /90.00 @:0 B@:0"); }
  void sayZones(double kpa) {
    for (int zone = 1; zone <= 4; ++zone)
      say("zone " + std::to_string(zone) + ": " + std::to_string(kpa) + " kPa");
  }
  void letPass(double seconds) {
    now_s += seconds;
    startup.elapse(now_s);
  }

  /// Runs a step as the machine would, or confirms it as the operator would.
  void perform(StartupStep step) {
    switch (step) {
      case StartupStep::PowerOn:
      case StartupStep::PlaceSheet:
        return startup.confirm(step, now_s);
      case StartupStep::DryPellets:
        startup.confirm(step, now_s);
        return letPass(4.0 * 3600.0);
      case StartupStep::TransferProgram:
        return startup.onTransferred(program, now_s);
      default:
        startup.begin(step, now_s);
    }
    while (startup.nextCode(step)) {
      if (step == StartupStep::HeatBed) sayBed(90.0);
      if (step == StartupStep::DrawVacuum) sayZones(12.0);
      if (const auto axis = homedAxis(step)) say("homed: " + homedAxes() + *axis);
      if (step == StartupStep::MapHeights) sayHeights();
      startup.onCodeFinished(step, now_s);
    }
  }
  std::string homedAxes() const {
    std::string axes;
    for (const StartupStep step : {StartupStep::HomeX, StartupStep::HomeY, StartupStep::HomeZ})
      if (stateOf(step) == StartupState::Done) axes += *homedAxis(step);
    return axes;
  }
  void sayHeights() {
    for (const char* line : {"Bilinear Leveling Grid:", " 0 +0.000 +0.100", " 1 +0.200 +0.150", "ok"})
      say(line);
  }
  /// Performs every step that is not done, in order.
  void performAll() {
    for (const StartupStatus& status : startup.steps())
      if (!isSatisfied(status)) perform(status.step);
  }

  StartupState stateOf(StartupStep step) const { return startup.stateOf(step); }
  std::string reasonOf(StartupStep step) const {
    for (const StartupStatus& status : startup.steps())
      if (status.step == step) return status.reason;
    return "no such step";
  }
  /// What a job is reported; empty if it may start.
  std::string refusal() const {
    try {
      startup.requireReadyFor(program);
      return {};
    } catch (const Rejected& error) {
      return error.what();
    }
  }

  Startup startup;
  double now_s = 0.0;

  ProgramIdentity program{"part.gcode", 1000, 0x12345678};
};

}  // namespace lamina::test
