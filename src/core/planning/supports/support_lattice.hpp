// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "planning/build_aids.hpp"
#include "planning/supports/support_areas.hpp"

namespace lamina {

/// What layers a lattice is for.
struct LatticePlace {
  double layer_height_mm = 0.0;  ///< for which lines are as far apart as the densities say, in all layers
  Point2 away = Point2::Zero();  ///< by which they were moved towards the origin
};

/// The lines of supports: of the lattice in one direction over the whole height, so that they stand on each
/// other, and of interfaces across.
/// @param areas           as many layers as the part; those that share regions share their lines
/// @return as many as layers, those of lower sections first
std::vector<LayerAids> supportLattice(const std::vector<LayerSupport>& areas, const PlanSettings& settings,
                                      const LatticePlace& place, Progress& progress);

/// Volumes of what is laid, by role.
void addVolumes(SupportTotals& totals, const std::vector<LayerAids>& supports);

}  // namespace lamina
