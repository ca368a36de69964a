// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/voids/beads/void_points.hpp"
#include "lamina/voids/drops/drop_overlap.hpp"

namespace lamina {

/// Whether voids are filled once and for all, or until no drop finds room.
enum class VoidPasses { Single, UntilFull };

/// How voids between drops are filled.
struct DropVoidSettings {
  bool is_on = false;    ///< as a step of slicing
  double overlap = 0.2;  ///< allowed between a new drop and any other
  OverlapDefinition definition = OverlapDefinition::Linear;
  VoidDetector detector = VoidDetector::Voronoi;
  VoidPasses passes = VoidPasses::Single;
  double least_share = 0.005;  ///< new drops per drop: with fewer, filling is said not to be worth it
};

/// Distance that a new drop keeps from any other, centre to centre [mm].
double leastDistance(const DropVoidSettings& settings, double diameter_mm);

/// Adds the keys drop_voids.*.
void describe(SettingsSchema& schema, DropVoidSettings& settings);

}  // namespace lamina
