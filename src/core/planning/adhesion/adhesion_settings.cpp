// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/adhesion/adhesion_settings.hpp"

namespace lamina {
namespace {

void describe(SettingsSchema& schema, BrimSettings& brim) {
  schema.number("brim.width_mm", brim.width_mm, {0.0, 100.0},
                "Width of the loops round the first layer, to the nearest whole loop; 0 for none.");
  schema.number("brim.gap_mm", brim.gap_mm, {0.0, 100.0}, "Free space between brim and part.");
  schema.choice<BrimWhere>(
      "brim.where", brim.where,
      {{"outside", BrimWhere::Outside}, {"inside", BrimWhere::Inside}, {"both", BrimWhere::Both}},
      "Round outlines, in holes, or both.");
  schema.flag("brim.ears", brim.ears, "Whether there is a brim at corners sharper than 100 deg only.");
}

void describe(SettingsSchema& schema, RaftSettings& raft) {
  schema.integer("raft.layers", raft.layers, {0, 100}, "Number of layers below the part; 0 for none.");
  schema.number("raft.base_height_mm", raft.base_height_mm, Bounds::above(0.0, 10.0),
                "Height of the first of them.");
  schema.integer("raft.top_layers", raft.top_layers, {0, 100}, "How many of them are solid.");
  schema.number("raft.margin_mm", raft.margin_mm, {0.0, 100.0},
                "By how much the raft is wider than what stands on it.");
  schema.number("raft.gap_mm", raft.gap_mm, {0.0, 10.0}, "Free space between raft and part.");
}

void describe(SettingsSchema& schema, PrimeSettings& prime) {
  schema.choice<PrimeLine>(
      "prime.line", prime.line,
      {{"none", PrimeLine::None}, {"front", PrimeLine::Front}, {"left", PrimeLine::Left}},
      "At which edge of the bed the nozzle is filled first.");
  schema.number("prime.length_mm", prime.length_mm, Bounds::above(0.0, 10000.0), "Length of that line.");
  schema.number("prime.section_mm2", prime.section_mm2, Bounds::above(0.0, 100.0),
                "Cross-section of that line's bead.");
}

}  // namespace

void describe(SettingsSchema& schema, AdhesionSettings& adhesion) {
  describe(schema, adhesion.brim);
  describe(schema, adhesion.raft);
  describe(schema, adhesion.prime);
}

}  // namespace lamina
