// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina {

/// Keys of the settings that have been stated.
struct StatedKeys {
  std::set<std::string> anywhere;  ///< by any source, profiles included
  std::set<std::string> typed;     ///< by the user who asks for the job, not by a profile
};

/// A setting whose built-in value does not fit the machine, with a value that fits.
struct MachineDefault {
  SettingText setting;
  std::string follows;  ///< key of the machine's setting from which it follows: "machine.has_fan"
};

/// The settings that follow from the machine, without settings that already have the value:
/// - no fan if `machine.has_fan` is false, and a cold bed if `machine.has_bed_heater` is false, unless typed;
/// - if `machine.nozzle_mm` is known, beads as wide as the nozzle; layers and first layer of half the
///   nozzle's width; adaptive layers from a quarter to three quarters of that width; each unless stated
///   anywhere;
/// - these heights, or the built-in ones, brought within `machine.least_layer_mm` and
///   `machine.greatest_layer_mm`, unless stated anywhere.
/// In modes whose first layer has no height of its own, it gets the common layer height.
std::vector<MachineDefault> machineDefaults(const JobSettings& settings, const StatedKeys& stated);

/// Keys of the settings that differ from the built-in ones. They count as stated if settings come from a file
/// that lists all of them.
std::set<std::string> changedKeys(const JobSettings& settings);

/// The settings, changed by what follows from the machine, and without what the mode leaves out (`leftOut`).
/// @param typed  keys that are not changed; former names of keys count too
JobSettings withMachineDefaults(JobSettings settings, const std::set<std::string>& typed);

}  // namespace lamina
