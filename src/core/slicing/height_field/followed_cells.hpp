// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/voxel/height_grid.hpp"
#include "lamina/slicing/height_field/height_field_settings.hpp"
#include "slicing/height_field/top_surface.hpp"

namespace lamina {

/// Which cells layers are to follow the top in: those where layers that do so are no steeper than the
/// greatest slope, and that are level or at least min_thickness / max_thickness as high as the highest of
/// them. Lower down layers would have to be thinner than they may.
/// @return for each cell 1 or 0; corners of a followed one have a prolonged height
std::vector<char> followedCells(const TopSurface& top, const HeightGrid& cells,
                                const HeightFieldSettings& settings);

}  // namespace lamina
