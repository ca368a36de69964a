// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/modifiers/plan_variant.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "planning/build_aids.hpp"
#include "planning/supports/support_areas.hpp"

namespace lamina {

/// The layers of a lattice.
struct LatticePlace {
  double layer_height_mm = 0.0;  ///< at which densities are converted to the spacing of lines, for all layers
  Point2 away = Point2::Zero();  ///< shift towards the origin already applied to the layers [mm]
  /// Regions whose supports have densities, angle and loops of their own; null for none.
  const std::vector<PlanVariant>* variants = nullptr;
};

/// The lines of supports. Those of the lattice have one direction over the whole height, so that they stand
/// on each other; those of interfaces are square to them.
/// @param areas           one per layer of the part; layers that share regions share their lines
/// @return one per layer, with the lines of lower sections first
std::vector<LayerAids> supportLattice(const std::vector<LayerSupport>& areas, const PlanSettings& settings,
                                      const LatticePlace& place, Progress& progress);

/// Adds the volumes of supports to totals, by role.
void addVolumes(SupportTotals& totals, const std::vector<LayerAids>& supports);

}  // namespace lamina
