// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// The firmware for which the command of the pressure advance is written.
enum class AdvanceWord : std::uint8_t {
  Dialect,  ///< firmware of the program's dialect; Marlin if the dialect is not known
  Marlin,
  Klipper,
  RepRapFirmware
};

/// Limits and lag of the flow through a nozzle.
struct FlowSettings {
  double greatest_mm3_s = 0.0;         ///< 0 for no limit
  double greatest_slope_mm3_s2 = 0.0;  ///< greatest rate of change along a run; 0 for no limit
  double coast_mm3 = 0.0;  ///< volume at the end of each run deposited by the remaining pressure; 0 for none
  double coast_longest_mm = 2.0;  ///< greatest length over which a run coasts
  double advance_s = 0.0;         ///< pressure advance of the firmware; 0 leaves it alone
  std::string advance_by_role;    ///< [s], as "outer_wall=0.04, infill=0.06"; `advance_s` for other roles
  AdvanceWord advance_word = AdvanceWord::Dialect;
  double lag_s = 0.0;        ///< time constant of the flow, which the program compensates; 0 for none
  double dead_time_s = 0.0;  ///< dead time of the flow, which the program compensates; 0 for none
};

/// Adds the keys flow.*.
void describe(SettingsSchema& schema, FlowSettings& settings);

/// Checks the settings for contradictions.
/// @throws InvalidConfig if both firmware and program are to compensate the lag, or `advance_by_role` is not
///   valid
void requireConsistent(const FlowSettings& settings);

}  // namespace lamina
