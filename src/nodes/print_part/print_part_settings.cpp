// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print_part_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, PrintPartSettings& settings) {
  schema.text("part", settings.part, "Mesh file to print, or the name of a parametric part.");
  schema.text("output_folder", settings.output_folder, "Folder for the program, pictures and reports.");
  schema.number("patience_s", settings.patience_s, Bounds::above(0.0, 3600.0),
                "How long another node may stay silent.");
  schema.number("scan.clearance_mm", settings.scan_clearance_mm, Bounds::above(0.0, 100.0),
                "Clearance that the scan passes are planned with.");
}

}  // namespace lamina
