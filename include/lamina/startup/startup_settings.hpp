// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/startup/startup_step.hpp"

namespace lamina {

/// What a machine's start-up consists of. The numbers are those of the large-format machine
/// [Garcia2024, section 3.5]; those that it does not give are listed in docs/streaming/startup.md.
///
/// Times are those of the machine, which may run faster than the wall's (`speed_up`). A step whose code is
/// empty is done by hand and confirmed by the operator. Labels are texts after which the machine's reports
/// give a value; an empty label means that the machine does not report it.
struct StartupSettings {
  std::string sequence;                              ///< names in order, separated by blanks; empty for none
  std::string skip;                                  ///< names that need not be done
  std::array<std::string, kStartupStepCount> after;  ///< further steps that each must wait for
  double speed_up = 1.0;           ///< machine time per wall time; above 1 with an emulated machine only
  double check_interval_s = 10.0;  ///< wall time
  std::string check_code = "M105";
  std::string abort_code = "M104 S0\nM140 S0";  ///< leaves the machine safe after an aborted sequence

  std::string dry_code;
  std::string dry_label;
  double dry_target_c = 80.0;
  double dry_tolerance_c = 15.0;  ///< below the target; a dryer that regenerates cools for a while
  double dry_h = 4.0;
  double dry_valid_h = 8.0;  ///< after it was last known to be dried

  std::string bed_code = "M140 S{target_c}";
  double bed_target_c = 90.0;
  double bed_tolerance_c = 1.0;
  double bed_rate_c_min = 3.0;      ///< at which the target is raised
  double bed_max_rate_c_min = 4.0;  ///< measured
  double bed_timeout_min = 60.0;

  std::string home_code = "G28 {axis}";
  std::string home_label;

  std::string vacuum_zones = "1 2 3 4";
  std::string vacuum_on_code;
  std::string vacuum_off_code;
  std::string vacuum_label;
  double vacuum_max_kpa = 40.0;     ///< absolute
  double vacuum_evacuate_s = 30.0;  ///< until the pressure must be reached
  double vacuum_hold_s = 30.0;      ///< over which it must be held

  std::string map_code = "G29";
  double map_flat_mm = 1.0;  ///< highest less lowest
  double map_valid_h = 24.0;
};

/// Adds the keys startup.*.
void describe(SettingsSchema& schema, StartupSettings& settings);

/// @throws InvalidConfig if there is none, one is no number, or one stands twice
std::vector<int> vacuumZones(const StartupSettings& settings);

}  // namespace lamina
