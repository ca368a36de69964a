// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Cross-section of a thread that spans a gap.
enum class BridgeThread : std::uint8_t {
  Bead,   ///< cross-section of all beads, times the flow
  Round,  ///< a cylinder, since nothing presses it flat
};

/// How an unsupported area that is held on both sides is deposited.
struct BridgeSettings {
  bool is_used = false;
  double anchor_mm = 1.0;   ///< length of threads on the material that holds them
  double least_held = 0.5;  ///< least share of length held at both ends that makes a bridge
  double longest_mm = 0.0;  ///< free spans longer than this are reported; 0: none
  double angle_deg = -1.0;  ///< direction of threads from x; below 0: the best one is searched for
  double flow = 1.0;        ///< factor on the cross-section of threads
  BridgeThread thread = BridgeThread::Bead;
  double thread_mm = 0.0;       ///< diameter of a round thread; 0 takes the bead width
  bool is_over_infill = false;  ///< the lowest skin over sparse infill is deposited as a bridge
};

/// Bridges of a part, and unsupported areas that are not bridged.
struct Bridging {
  std::size_t bridges = 0;   ///< number of bridged pieces
  std::size_t too_long = 0;  ///< number of bridges with a free span above `BridgeSettings::longest_mm`
  double longest_mm = 0.0;   ///< longest free span
  std::size_t unheld = 0;    ///< unsupported pieces that are not held on both sides
  double unheld_mm2 = 0.0;

  Bridging& operator+=(const Bridging& other);
};

/// Adds the keys bridges.*.
void describe(SettingsSchema& schema, BridgeSettings& settings);

}  // namespace lamina
