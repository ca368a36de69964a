// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/startup/machine_reports.hpp"

namespace lamina {

enum class Verdict : std::uint8_t {
  Met,
  NotMet,   ///< what was measured is out of its bounds
  Unknown,  ///< nothing was measured
};

/// What was measured of a step against what is expected.
struct StartupCheck {
  Verdict verdict = Verdict::Unknown;
  std::string reason;  ///< with actual value, unit and expected
  std::optional<double> value;
  std::string unit;
  std::string expected;
};

/// How strictly a temperature is looked at: one that was reached may waver about its target.
enum class Strictness : std::uint8_t { Reaching, Keeping };

StartupCheck checkBed(const MachineReports& reports, const StartupSettings& settings, Strictness strictness);
/// Whether the bed heats no faster than it may.
StartupCheck checkBedRate(const MachineReports& reports, const StartupSettings& settings);
/// @param dried_s  time at the temperature so far
StartupCheck checkDrying(double dried_s, const StartupSettings& settings);
/// Whether the dryer is hot enough.
StartupCheck checkDryer(const MachineReports& reports, const StartupSettings& settings);
StartupCheck checkHomed(char axis, const MachineReports& reports);
/// Names the first zone that does not hold, or was not reported.
StartupCheck checkVacuum(const MachineReports& reports, const StartupSettings& settings);
StartupCheck checkHeights(const MachineReports& reports, const StartupSettings& settings);

}  // namespace lamina
