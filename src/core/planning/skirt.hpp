// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Loops round the convex hull of the first layer, outermost first: between hull and innermost bead the
/// skirt's distance is left free. More loops than `skirt.count` where `skirt.least_length_mm` asks for
/// them. None round nothing.
std::vector<Polygon> makeSkirt(const Regions& first_layer, const PlanSettings& settings);

}  // namespace lamina
