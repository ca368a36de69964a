// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

/// A step of a machine's start-up [Garcia2024, section 3.5].
enum class StartupStep : std::uint8_t {
  PowerOn,     ///< the operator switches the machine on
  DryPellets,  ///< the material is kept at a temperature for a time
  HeatBed,     ///< at a rate
  HomeX,       ///< the axes one after the other
  HomeY,
  HomeZ,
  PlaceSheet,       ///< the operator lays the sheet on the bed
  DrawVacuum,       ///< the zones that hold the sheet
  HomeZAgain,       ///< against the sheet
  MapHeights,       ///< of the bed's surface
  TransferProgram,  ///< whole
};

inline constexpr std::size_t kStartupStepCount = 11;

/// The name in settings and messages: "heat_bed".
const char* toString(StartupStep step);
/// Every step, in the order of the operator's procedure.
const std::vector<StartupStep>& allStartupSteps();
/// Nothing if there is no step of that name.
std::optional<StartupStep> startupStepFromText(const std::string& name);
/// 'X', 'Y' or 'Z' of a step that homes an axis, or nothing.
std::optional<char> homedAxis(StartupStep step);

/// The numbers are those of msg/StartupStep.msg; a test compares them.
enum class StartupState : std::uint8_t {
  Pending = 0,  ///< not done, or what was done has been lost
  Running = 1,
  Done = 2,
  Failed = 3,
  Skipped = 4,  ///< by configuration
};

/// "Pending"
const char* toString(StartupState state);

/// How far a step is.
struct StartupStatus {
  StartupStep step = StartupStep::PowerOn;
  StartupState state = StartupState::Pending;
  std::string reason;           ///< why it is in that state, in words
  std::optional<double> value;  ///< what was measured last
  std::string unit;             ///< of the value
  std::string expected;         ///< "89 to 91 degC"; empty if nothing is measured
};

/// Done or skipped.
inline bool isSatisfied(const StartupStatus& status) {
  return status.state == StartupState::Done || status.state == StartupState::Skipped;
}

}  // namespace lamina
