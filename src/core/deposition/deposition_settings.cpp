// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/deposition_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, DepositionSettings& settings) {
  schema.number("deposition.voxel_mm", settings.voxel_mm, {0.001, 100.0},
                "Side of the voxels into which a toolpath is deposited.");
  schema.number("deposition.step", settings.step, {0.05, 2.0},
                "Way of the nozzle from portion to portion of material, in radii of the strand.");
  schema.number("deposition.reach_mm", settings.reach_mm, {0.01, 1000.0},
                "Farthest from the middle of the strand that material goes to find room.");
  schema.number("deposition.bed_z_mm", settings.bed_z_mm, {-1e6, 1e6},
                "Height below which nothing is deposited.");
  schema.flag("deposition.skirt", settings.are_build_aids_deposited,
              "Whether what does not belong to the part is deposited too: skirts, brims, rafts, supports and "
              "priming.");
  schema.number("deposition.memory_limit_mb", settings.memory_limit_mb, {0.0, 1e9},
                "Memory the voxels may take; 0 for what is free on the machine.");
}

}  // namespace lamina
