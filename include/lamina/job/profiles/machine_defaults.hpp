// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina {

/// The keys of settings that have been stated.
struct StatedKeys {
  std::set<std::string> anywhere;  ///< by any source, profiles among them
  std::set<std::string> typed;     ///< by whoever asks for the job, not by a profile
};

/// What a setting is on a machine where its built-in value does not fit.
struct MachineDefault {
  SettingText setting;
  std::string follows;  ///< key of the machine that it follows from: "machine.has_fan"
};

/// What follows from the machine, without what is so already:
/// - no fan without `machine.has_fan` and a cold bed without `machine.has_bed_heater`, unless typed;
/// - where `machine.nozzle_mm` is known, beads as wide as the nozzle, layers and the first layer half as
///   high, adaptive layers from a quarter of it to three quarters, unless stated anywhere;
/// - these heights, and the built-in ones, within `machine.least_layer_mm` and `machine.greatest_layer_mm`.
/// In modes whose first layer has no height of its own, it has that of all layers.
std::vector<MachineDefault> machineDefaults(const JobSettings& settings, const StatedKeys& stated);

/// The keys of settings that differ from the built-in ones: those that somebody has stated, where files state
/// all of them.
std::set<std::string> changedKeys(const JobSettings& settings);

/// The settings with what follows from the machine.
/// @param typed  keys that stay as they are; names of former releases count
JobSettings withMachineDefaults(JobSettings settings, const std::set<std::string>& typed);

}  // namespace lamina
