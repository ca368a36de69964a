// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Loops round the convex hull of the first layer, outermost first. The gap between hull and innermost bead
/// is the skirt's distance. There are more loops than `skirt.count` if `skirt.least_length_mm` requires them,
/// and none round an empty layer.
std::vector<Polygon> makeSkirt(const Regions& first_layer, const PlanSettings& settings);

}  // namespace lamina
