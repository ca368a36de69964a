// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/startup/startup_step.hpp"

namespace lamina {

/// Steps of a machine's start-up sequence, and their parameters. The numbers are those of the large-format
/// machine [Garcia2024, section 3.5]; numbers that the source does not give are listed in
/// docs/streaming/startup.md.
///
/// Times are machine times, which pass `speed_up` times as fast as wall time. A code is G-code; if the code
/// of a step is empty, the operator does the step by hand and confirms it. A label is the text in the
/// machine's reports after which a value stands; if it is empty, the machine does not report the value.
struct StartupSettings {
  std::string sequence;  ///< names of the steps in order, separated by blanks; empty for no sequence
  std::string skip;      ///< names of steps of the sequence that need not be done
  /// Names of further prerequisites of each step, by `StartupStep`.
  std::array<std::string, kStartupStepCount> after;
  double speed_up = 1.0;            ///< machine time per wall time; above 1 with an emulated machine only
  double check_interval_s = 10.0;   ///< wall time between two checks while no job is under way
  std::string check_code = "M105";  ///< makes the machine report its state
  std::string abort_code = "M104 S0\nM140 S0";  ///< makes the machine safe after an aborted sequence

  std::string dry_code;           ///< switches the dryer on; {target_c} is replaced
  std::string dry_label;          ///< of the dryer's temperature
  double dry_target_c = 80.0;     ///< temperature of the dryer
  double dry_tolerance_c = 15.0;  ///< allowed below the target, as a dryer cools while it regenerates
  double dry_h = 4.0;             ///< duration of drying
  /// Time after which pellets that are not known to be kept dry must be dried again.
  double dry_valid_h = 8.0;

  std::string bed_code = "M140 S{target_c}";  ///< sets the bed's target; {target_c} is replaced
  double bed_target_c = 90.0;                 ///< temperature of the bed
  double bed_tolerance_c = 1.0;               ///< allowed above and below the target
  double bed_rate_c_min = 3.0;                ///< rate at which the target is raised [K/min]
  double bed_max_rate_c_min = 4.0;            ///< greatest measured heating rate that is allowed [K/min]
  double bed_timeout_min = 60.0;              ///< time within which the bed must reach the target

  std::string home_code = "G28 {axis}";  ///< homes an axis; {axis} is replaced
  std::string home_label;                ///< of the letters of the homed axes

  std::string vacuum_zones = "1 2 3 4";  ///< numbers of the zones that must hold the sheet
  std::string vacuum_on_code;            ///< opens a zone; {zone} is replaced
  std::string vacuum_off_code;           ///< closes a zone; {zone} is replaced
  std::string vacuum_label;              ///< of a zone's pressure [kPa]; {zone} is replaced
  double vacuum_max_kpa = 40.0;          ///< greatest absolute pressure that is allowed
  double vacuum_evacuate_s = 30.0;       ///< time after which the pressure must be reached
  double vacuum_hold_s = 30.0;           ///< time for which the pressure must then be held

  std::string map_code = "G29";  ///< measures and prints the height map
  double map_flat_mm = 1.0;      ///< greatest difference of heights that is allowed
  double map_valid_h = 24.0;     ///< time after which the height map must be measured again
};

/// Adds the keys startup.*.
void describe(SettingsSchema& schema, StartupSettings& settings);

/// The numbers of the vacuum zones of the settings.
/// @throws InvalidConfig if there is none, one is no number, or one is given twice
std::vector<int> vacuumZones(const StartupSettings& settings);

}  // namespace lamina
