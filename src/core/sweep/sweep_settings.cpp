// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/sweep_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, SweepSettings& settings) {
  schema.choice<CornerStrategy>("sweep.corners", settings.corners,
                                {{toString(CornerStrategy::Whole), CornerStrategy::Whole},
                                 {toString(CornerStrategy::Lines), CornerStrategy::Lines},
                                 {toString(CornerStrategy::Revolved), CornerStrategy::Revolved},
                                 {toString(CornerStrategy::Sections), CornerStrategy::Sections}},
                                "How swept beads go round corners.");
  schema.choice<CutHeight>(
      "sweep.cut_height", settings.cut_height, {{"bead", CutHeight::Bead}, {"absolute", CutHeight::Absolute}},
      "Height from which the width that decides on cuts is found; absolute is as published.");
  schema.number("sweep.voxel_mm", settings.voxel_mm, {1e-3, 10.0},
                "Step of the lattice on which the surface of swept beads is found.");
}

const char* toString(CornerStrategy strategy) {
  switch (strategy) {
    case CornerStrategy::Whole:
      return "whole";
    case CornerStrategy::Lines:
      return "lines";
    case CornerStrategy::Revolved:
      return "revolved";
    case CornerStrategy::Sections:
      break;
  }
  return "sections";
}

}  // namespace lamina
