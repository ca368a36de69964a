// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

enum class BrimWhere { Outside, Inside, Both };

/// Loops in the first layer that hold the part down.
struct BrimSettings {
  double width_mm = 0.0;  ///< 0: none
  double gap_mm = 0.0;    ///< between part and innermost loop
  BrimWhere where = BrimWhere::Outside;
  bool ears = false;  ///< whether there are loops at sharp corners only
};

/// Layers below the part.
struct RaftSettings {
  int layers = 0;               ///< number, the base included; 0: none
  double base_height_mm = 0.3;  ///< height of the lowest layer
  int top_layers = 2;           ///< number of solid layers on top
  double margin_mm = 3.0;       ///< distance by which the raft extends beyond all that stands on it
  double gap_mm = 0.15;         ///< between raft and part
};

enum class PrimeLine { None, Front, Left };

/// A line at the edge of the bed that primes the nozzle.
struct PrimeSettings {
  PrimeLine line = PrimeLine::None;
  double length_mm = 100.0;
  double section_mm2 = 0.5;  ///< cross-section of its bead
};

/// Brim and raft that hold a part to the bed, and a line that primes the nozzle before the part. All are off
/// by default.
struct AdhesionSettings {
  BrimSettings brim;
  RaftSettings raft;
  PrimeSettings prime;
};

/// Whether brim, raft or prime line is used.
inline bool isUsed(const AdhesionSettings& settings) {
  return settings.brim.width_mm > 0.0 || settings.raft.layers > 0 || settings.prime.line != PrimeLine::None;
}

/// Adds the keys brim.*, raft.* and prime.*.
void describe(SettingsSchema& schema, AdhesionSettings& adhesion);

}  // namespace lamina
