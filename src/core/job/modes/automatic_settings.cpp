// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/modes/automatic_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, AutomaticSettings& settings) {
  schema.number("auto.good_unsupported_percent", settings.good_unsupported_percent, {0.0, 100.0},
                "Of the part's surface: what a mode may leave unsupported and still be good enough.");
  schema.number("auto.alike_percent", settings.alike_percent, {0.0, 100.0},
                "Of the part's surface: unsupported shares that differ by no more count as alike.");
  schema.number("auto.longest_time", settings.longest_time, {1.0, 1000.0},
                "Longest printing time of a mode, over that of the quickest one that takes the part.");
  schema.number("auto.max_overhang_deg", settings.max_overhang_deg, {0.0, 60.0},
                "Greatest overhang that the material takes, whatever the mode; stands in for "
                "directions.max_overhang_deg and volumetric.max_overhang_deg.");
  schema.flag("auto.follow_skins", settings.follows_skins,
              "Whether layers that follow gentle slopes are tried first, where level ones leave steps.");
}

}  // namespace lamina
