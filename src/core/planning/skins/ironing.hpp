// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/infill/fill_path.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Whether lines of this role are deposited in one order across them, so that no line is deposited between
/// two earlier ones.
bool laysInOneSense(const SkinSettings& settings, PathRole role);

/// Zigzag lines of ironing over visible areas [mm]. Places narrower than twice the inset get none.
/// @param seen  areas of one layer that are visible from above
std::vector<FillPath> ironingLines(const Regions& seen, const IroningSettings& settings, double angle_rad);

/// The bead of ironing [mm]: as high as the layer, and as narrow as the flow requires. It lies within
/// material that is there already: measures of areas count its volume only.
Bead ironingBead(const IroningSettings& settings, double layer_height_mm);

}  // namespace lamina
