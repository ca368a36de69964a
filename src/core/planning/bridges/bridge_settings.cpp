// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/bridges/bridge_settings.hpp"

#include <algorithm>

namespace lamina {

Bridging& Bridging::operator+=(const Bridging& other) {
  bridges += other.bridges;
  too_long += other.too_long;
  longest_mm = std::max(longest_mm, other.longest_mm);
  unheld += other.unheld;
  unheld_mm2 += other.unheld_mm2;
  return *this;
}

void describe(SettingsSchema& schema, BridgeSettings& bridges) {
  schema.flag("bridges.use", bridges.is_used,
              "Whether what lies over nothing is deposited as threads from one side to the other.");
  schema.number("bridges.anchor_mm", bridges.anchor_mm, Bounds::above(0.0, 50.0),
                "By how much threads go on over what holds them.");
  schema.number("bridges.least_held", bridges.least_held, {0.0, 1.0},
                "Share of the threads that both sides hold; below it there is no bridge.");
  schema.number("bridges.longest_mm", bridges.longest_mm, {0.0, 1e4},
                "Longer free spans are reported; 0 for none.");
  schema.number("bridges.angle_deg", bridges.angle_deg, {-1.0, 180.0},
                "Direction of threads, from x; -1 seeks the best.");
  schema.number("bridges.flow", bridges.flow, {0.1, 3.0}, "Factor on the cross-section of threads.");
  schema.choice<BridgeThread>("bridges.thread", bridges.thread,
                              {{"bead", BridgeThread::Bead}, {"round", BridgeThread::Round}},
                              "Cross-section of threads: that of a bead, or a circle.");
  schema.number("bridges.thread_mm", bridges.thread_mm, {0.0, 100.0},
                "Diameter of round threads, that of the nozzle; 0 takes bead.width_mm.");
  schema.flag("bridges.over_infill", bridges.is_over_infill,
              "Whether the lowest skin over sparse infill is deposited across its lines, as a bridge.");
}

}  // namespace lamina
