// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/job/incline_settings.hpp"
#include "lamina/program/program_settings.hpp"

namespace lamina {

struct GcodeInclinerSettings {
  InclineSettings incline;
  ProgramSettings program;           ///< filament and flow by which programs are read for viewing
  double largest_viewed_mb = 100.0;  ///< larger programs are inclined, but not published
};

/// Adds the keys of `InclineSettings`, program.filament_diameter_mm, program.flow and
/// view.largest_program_mb.
void describe(SettingsSchema& schema, GcodeInclinerSettings& settings);

}  // namespace lamina
