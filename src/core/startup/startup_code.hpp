// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// Whether the step is done by the operator, who confirms it.
bool isDoneByHand(StartupStep step, const StartupSettings& settings);

/// Whether the machine reports what the step is about.
bool isReported(StartupStep step, const StartupSettings& settings);

}  // namespace lamina
