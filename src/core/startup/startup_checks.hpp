// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/startup/machine_reports.hpp"

namespace lamina {

enum class Verdict : std::uint8_t {
  Met,
  NotMet,   ///< the measured value is outside its bounds
  Unknown,  ///< no value was measured
};

/// Result of comparing a measurement of a step with what is expected.
struct StartupCheck {
  Verdict verdict = Verdict::Unknown;
  std::string reason;  ///< states actual value, unit and expected value
  std::optional<double> value;
  std::string unit;
  std::string expected;
};

/// How strictly a temperature is checked: once reached, it may vary about its target.
enum class Strictness : std::uint8_t { Reaching, Keeping };

StartupCheck checkBed(const MachineReports& reports, const StartupSettings& settings, Strictness strictness);
/// Checks that the bed heats no faster than allowed.
StartupCheck checkBedRate(const MachineReports& reports, const StartupSettings& settings);
/// Checks the time of drying.
/// @param dried_s  time at the temperature so far
StartupCheck checkDrying(double dried_s, const StartupSettings& settings);
/// Checks that the dryer is hot enough.
StartupCheck checkDryer(const MachineReports& reports, const StartupSettings& settings);
StartupCheck checkHomed(char axis, const MachineReports& reports);
/// Checks that all zones hold their vacuum; names the first that does not, or was not reported.
StartupCheck checkVacuum(const MachineReports& reports, const StartupSettings& settings);
StartupCheck checkHeights(const MachineReports& reports, const StartupSettings& settings);

}  // namespace lamina
