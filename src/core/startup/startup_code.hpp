// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/startup/startup_settings.hpp"

namespace lamina {

/// The text with every occurrence of `place` replaced.
std::string filled(std::string text, std::string_view place, const std::string& by);

/// A number with as few decimals as it needs: "89.5".
std::string shortNumber(double value);

/// G-code that raises the bed's target, kelvin by kelvin from `from_c`, at the rate of the settings.
std::string bedRamp(const StartupSettings& settings, double from_c);

/// G-code for a wait, in pieces short enough that it can be stopped between them.
std::string dwell(double seconds);

/// G-code that switches all zones on.
std::string vacuumOn(const StartupSettings& settings);

/// The commands that switch zones off, each trimmed; empty if none are configured.
std::vector<std::string> vacuumOffCommands(const StartupSettings& settings);

/// The code of a command: "M140" of "M140 S60" and of "M140S60"; its first word if that is another name.
std::string codeOf(const std::string& command);

/// The target that M140 or M190 sets [degC]; nothing if it names none.
std::optional<double> bedTargetIn(const std::string& command);

/// Axes whose motors an M84 or M18 switches off: those it names, or all.
std::string axesOf(const std::string& command);

/// Whether a text is the firmware's refusal to move before homing: Marlin's "echo:Home XYZ First",
/// RepRapFirmware's "Error: G0/G1: insufficient axes homed".
bool asksForHoming(const std::string& text);

/// Whether the operator does the step by hand, and confirms it.
bool isDoneByHand(StartupStep step, const StartupSettings& settings);

/// Whether the machine reports the quantity that the step is about.
bool isReported(StartupStep step, const StartupSettings& settings);

}  // namespace lamina
