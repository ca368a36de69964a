// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/drops/drop_void_settings.hpp"

namespace lamina {

double leastDistance(const DropVoidSettings& settings, double diameter_mm) {
  return diameter_mm * distanceOfOverlap(settings.overlap, settings.definition);
}

void describe(SettingsSchema& schema, DropVoidSettings& settings) {
  schema.flag("drop_voids.fill", settings.is_on, "Whether voids between drops are filled with drops.");
  schema.number("drop_voids.overlap", settings.overlap, {0.0, 0.95},
                "Overlap of a new drop with any other that is allowed.");
  schema.choice<OverlapDefinition>("drop_voids.definition", settings.definition,
                                   {{"linear", OverlapDefinition::Linear}, {"area", OverlapDefinition::Area}},
                                   "What overlap is a share of: the diameter, or the area of a drop.");
  schema.choice<VoidDetector>("drop_voids.detector", settings.detector,
                              {{"voronoi", VoidDetector::Voronoi}, {"neighbours", VoidDetector::Neighbours}},
                              "How voids are found.");
  schema.choice<VoidPasses>("drop_voids.passes", settings.passes,
                            {{"single", VoidPasses::Single}, {"until_full", VoidPasses::UntilFull}},
                            "Whether voids are searched once, or again until no drop finds room.");
  schema.number("drop_voids.least_share", settings.least_share, {0.0, 1.0},
                "New drops per drop of the program; with fewer, filling is said not to be worth it.");
}

}  // namespace lamina
