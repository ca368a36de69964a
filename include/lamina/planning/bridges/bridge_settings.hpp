// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "lamina/base/settings.hpp"

namespace lamina {

/// Cross-section of what spans a gap.
enum class BridgeThread : std::uint8_t {
  Bead,   ///< that of all beads, times the flow
  Round,  ///< a cylinder, as it is when nothing presses it flat
};

/// How what lies over nothing is laid, where it is held on both sides.
struct BridgeSettings {
  bool is_used = false;
  double anchor_mm = 1.0;   ///< by which threads go on over what holds them
  double least_held = 0.5;  ///< share of the length that is held at both ends; below it is no bridge
  double longest_mm = 0.0;  ///< longer free spans are told; 0 for none
  double angle_deg = -1.0;  ///< of the threads, from x; below 0 it is sought
  double flow = 1.0;        ///< on the cross-section of the threads
  BridgeThread thread = BridgeThread::Bead;
  double thread_mm = 0.0;       ///< diameter of a round thread; 0 takes the bead width
  bool is_over_infill = false;  ///< the lowest skin over sparse infill is laid as a bridge
};

/// Bridges of a part, and what could be none.
struct Bridging {
  std::size_t bridges = 0;
  std::size_t too_long = 0;  ///< of them
  double longest_mm = 0.0;   ///< free span
  std::size_t unheld = 0;    ///< pieces over nothing that are not held on both sides
  double unheld_mm2 = 0.0;

  Bridging& operator+=(const Bridging& other);
};

/// Adds the keys bridges.*.
void describe(SettingsSchema& schema, BridgeSettings& settings);

}  // namespace lamina
