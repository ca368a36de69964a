// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/infill/fill_path.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Whether that role is laid so that no line lies between two laid before it.
bool laysInOneSense(const SkinSettings& settings, PathRole role);

/// Lines of ironing over what is seen, to and fro [mm]. What is narrower than twice the inset gets none.
/// @param seen  of one layer
std::vector<FillPath> ironingLines(const Regions& seen, const IroningSettings& settings, double angle_rad);

/// As high as the layer and so narrow that it holds what the flow says [mm]: it lies in what is there
/// already, so that measures of areas count no more than that volume.
Bead ironingBead(const IroningSettings& settings, double layer_height_mm);

}  // namespace lamina
