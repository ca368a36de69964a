// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/startup/startup_settings.hpp"

namespace lamina {

/// The text with every `place` replaced.
std::string filled(std::string text, std::string_view place, const std::string& by);

/// "89.5": as short as it is exact.
std::string shortNumber(double value);

/// G-code that raises the bed's target from a temperature at the rate of the settings, kelvin by kelvin.
std::string bedRamp(const StartupSettings& settings, double from_c);

/// G-code that lets the machine wait, in pieces short enough for it to be stopped between them.
std::string dwell(double seconds);

/// G-code that switches all zones on.
std::string vacuumOn(const StartupSettings& settings);

/// The commands that switch zones off, each trimmed; none if that is not configured.
std::vector<std::string> vacuumOffCommands(const StartupSettings& settings);

/// The code of a command: "M140" of "M140 S60".
std::string codeOf(const std::string& command);

/// The target that M140 or M190 sets [degC]; nothing if it names none.
std::optional<double> bedTargetIn(const std::string& command);

/// Axes whose motors M84 or M18 switches off: those it names, or all.
std::string axesOf(const std::string& command);

/// Whether firmware refuses to move before homing: Marlin's "echo:Home XYZ First", RepRapFirmware's "Error:
/// G0/G1: insufficient axes homed".
bool asksForHoming(const std::string& text);

/// Whether the step is done by the operator, who confirms it.
bool isDoneByHand(StartupStep step, const StartupSettings& settings);

/// Whether the machine reports what the step is about.
bool isReported(StartupStep step, const StartupSettings& settings);

}  // namespace lamina
