// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How the profile goes round the corners of a trajectory [Vega2023, section 3.1.3].
enum class CornerStrategy : std::uint8_t {
  Whole = 0,     ///< each trajectory one sweep, mitred at its corners
  Lines = 1,     ///< each line a sweep of its own with flat ends
  Revolved = 2,  ///< the same, and the profile revolved about the upright through each corner
  Sections = 3   ///< trajectories cut where they would meet themselves, each section mitred
};

/// Bead height used where the bead's width decides whether a trajectory meets itself.
enum class CutHeight : std::uint8_t {
  Bead = 0,      ///< that of the bead
  Absolute = 1,  ///< that of the layer above the bed, as in [Vega2023]: too wide in upper layers
};

/// How beads are swept.
struct SweepSettings {
  CornerStrategy corners = CornerStrategy::Sections;
  CutHeight cut_height = CutHeight::Bead;
  double voxel_mm = 0.1;  ///< of the lattice on which the surface is found
};

/// Adds the keys sweep.*.
void describe(SettingsSchema& schema, SweepSettings& settings);

/// As in settings: "sections".
const char* toString(CornerStrategy strategy);

}  // namespace lamina
