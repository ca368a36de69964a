// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved/curved_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, CurvedSettings& settings) {
  schema.number(
      "curved.normal_limit", settings.normal_limit, {0.0, 0.9},
      "Surfaces whose unit normal has a z within this of 0 count as upright: neither lower nor upper.");
  schema.number("curved.longest_edge_mm", settings.longest_edge_mm, Bounds::above(0.0, 100.0),
                "Longer edges of the surfaces that layers grow from are halved.");
  schema.number("curved.largest_gap_percent", settings.largest_gap_percent, Bounds::above(0.0, 100.0),
                "Of the part: how much may be in no layer or in more than one before it is refused.");
  schema.number("curved.largest_void_mm3", settings.largest_void_mm3, Bounds::above(0.0, 1e9),
                "Of the part: how much that is in no layer may hang together before it is refused.");
}

}  // namespace lamina
