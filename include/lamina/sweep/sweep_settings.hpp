// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How corners of a trajectory are swept [Vega2023, section 3.1.3].
enum class CornerStrategy : std::uint8_t {
  Whole = 0,     ///< each trajectory is one sweep, mitred at its corners
  Lines = 1,     ///< each line is a sweep with flat ends
  Revolved = 2,  ///< as Lines, with the profile revolved about the vertical axis through each corner
  Sections = 3   ///< each trajectory is cut where it would intersect itself; each section is a mitred sweep
};

/// Height from which the bead width is computed for the test whether a trajectory intersects itself.
enum class CutHeight : std::uint8_t {
  Bead = 0,      ///< height of the bead
  Absolute = 1,  ///< height of the layer above the bed, as in [Vega2023]; wrong in upper layers
};

/// How beads are swept.
struct SweepSettings {
  CornerStrategy corners = CornerStrategy::Sections;
  CutHeight cut_height = CutHeight::Bead;
  double voxel_mm = 0.1;  ///< side of the voxels by which the surface is found
};

/// Adds the keys sweep.*.
void describe(SettingsSchema& schema, SweepSettings& settings);

/// The name of a strategy in settings, such as "sections".
const char* toString(CornerStrategy strategy);

}  // namespace lamina
