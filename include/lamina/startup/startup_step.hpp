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
  HeatBed,     ///< the bed is heated at a limited rate
  HomeX,       ///< the axes are homed one after the other
  HomeY,
  HomeZ,
  PlaceSheet,       ///< the operator places the sheet on the bed
  DrawVacuum,       ///< the vacuum zones that hold the sheet are evacuated
  HomeZAgain,       ///< Z is homed again, over the sheet
  MapHeights,       ///< the heights of the bed's surface are measured
  TransferProgram,  ///< the program has arrived completely
};

inline constexpr std::size_t kStartupStepCount = 11;

/// The name of a step in settings and messages, such as "heat_bed".
const char* toString(StartupStep step);
/// All steps, in the order of the operator's procedure.
const std::vector<StartupStep>& allStartupSteps();
/// The step of a name; nothing if there is none.
std::optional<StartupStep> startupStepFromText(const std::string& name);
/// The axis that a step homes, 'X', 'Y' or 'Z'; nothing for other steps.
std::optional<char> homedAxis(StartupStep step);

/// State of a step. The values are those of msg/StartupStep.msg; a test compares them.
enum class StartupState : std::uint8_t {
  Pending = 0,  ///< not done, or its result was lost
  Running = 1,
  Done = 2,
  Failed = 3,
  Skipped = 4,  ///< not to be done, by the settings
};

/// The name of a state, such as "Pending".
const char* toString(StartupState state);

/// The status of a step.
struct StartupStatus {
  StartupStep step = StartupStep::PowerOn;
  StartupState state = StartupState::Pending;
  std::string reason;           ///< why it is in that state, in words
  std::optional<double> value;  ///< last measured value; nothing if none was measured
  std::string unit;             ///< of the value
  std::string expected;         ///< expected value, such as "89 to 91 degC"; empty if nothing is measured
};

/// Whether a step is Done or Skipped.
inline bool isSatisfied(const StartupStatus& status) {
  return status.state == StartupState::Done || status.state == StartupState::Skipped;
}

}  // namespace lamina
