// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/voids/beads/void_points.hpp"
#include "lamina/voids/drops/drop_overlap.hpp"

namespace lamina {

/// Whether voids are searched once, or again until there is no room for another drop.
enum class VoidPasses { Single, UntilFull };

/// How voids between drops are filled.
struct DropVoidSettings {
  bool is_on = false;    ///< whether voids are filled as a step of slicing
  double overlap = 0.2;  ///< greatest overlap of a new drop with any other
  OverlapDefinition definition = OverlapDefinition::Linear;
  VoidDetector detector = VoidDetector::Voronoi;
  VoidPasses passes = VoidPasses::Single;
  double least_share = 0.005;  ///< new drops per prior drop below which filling is reported as not worthwhile
};

/// Least distance of the centre of a new drop from that of any other [mm].
double leastDistance(const DropVoidSettings& settings, double diameter_mm);

/// Adds the keys drop_voids.*.
void describe(SettingsSchema& schema, DropVoidSettings& settings);

}  // namespace lamina
