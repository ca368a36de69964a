// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What to print and where its files go.
struct PrintPartSettings {
  std::string part = "blade";            ///< a mesh file, or the name of a parametric part
  std::string output_folder = "output";  ///< for part.gcode, toolpath.png and summary
  double patience_s = 120.0;             ///< longest silence of another node
  double scan_clearance_mm = 1.0;        ///< clearance with which the scan passes are planned
};

/// Adds the keys part, output_folder, patience_s and scan.clearance_mm.
void describe(SettingsSchema& schema, PrintPartSettings& settings);

}  // namespace lamina
