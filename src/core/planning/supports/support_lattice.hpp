// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "planning/build_aids.hpp"
#include "planning/supports/support_areas.hpp"

namespace lamina {

/// The lines of supports: of the lattice in one direction over the whole height, so that they stand on each
/// other, and of interfaces across.
/// @param areas           as many layers as the part; those that share regions share their lines
/// @param layer_height_mm for which lines are as far apart as the densities say, in all layers
/// @return as many as layers, those of lower sections first
std::vector<LayerAids> supportLattice(const std::vector<LayerSupport>& areas, const PlanSettings& settings,
                                      double layer_height_mm, Progress& progress);

/// Volumes of what is laid, by role.
void addVolumes(SupportTotals& totals, const std::vector<LayerAids>& supports);

}  // namespace lamina
