// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "messages.hpp"

namespace lamina {

/// Where a toolpath is run dry, with nothing of its process on.
enum class DryPlace : std::uint8_t {
  None,   ///< it is run with its process
  Air,    ///< on the toolpath
  Lift,   ///< above it, along the tool axis
  Point,  ///< with the tip of a pointer on it
};

/// Whether the process is on as the toolpath states.
enum class ProcessUse : std::uint8_t { AsPlanned, Off };

/// How toolpaths are run dry.
struct DrySettings {
  double lift_mm = 20.0;           ///< above the toolpath, along the tool axis
  std::vector<double> pointer_mm;  ///< its tip in the nozzle's frame; empty without a pointer
};

/// Adds the keys dry.*.
void describe(SettingsSchema& schema, DrySettings& settings);

struct DryOrder {
  DryPlace place = DryPlace::None;
  double speed = 1.0;  ///< of the planned speeds

  ProcessUse process() const { return place == DryPlace::None ? ProcessUse::AsPlanned : ProcessUse::Off; }
};

/// @throws InvalidInput if there is no such dry run, the speed is out of its bounds, or a speed is stated for
///   a job with its process
DryOrder dryOrderOf(const lamina_msgs::DriveToolpathGoal& goal);

/// The toolpath as it is driven.
/// @throws InvalidInput if the pointer that is to be on the toolpath is not known
Toolpath drivenAs(const DryOrder& order, Toolpath toolpath, const DrySettings& settings);

}  // namespace lamina
