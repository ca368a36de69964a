// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/overhang/overhang_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, OverhangSettings& settings) {
  schema.flag("overhang.report", settings.is_shown,
              "Whether the slicing node looks for beads with nothing below them and shows them.");
  schema.number("overhang.step_mm", settings.step_mm, {0.01, 100.0},
                "Greatest distance between the places of a bead that are looked at.");
  schema.number("overhang.reach", settings.reach, Bounds::above(0.5, 10.0),
                "How far from its middle along the tool axis a bead must meet something, in bead heights.");
  schema.number("overhang.overlap", settings.overlap, {0.0, 0.5},
                "Least part of the width of a bead that must lie on something.");
}

}  // namespace lamina
