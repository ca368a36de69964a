// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/voxel/height_grid.hpp"
#include "lamina/slicing/height_field/height_field_settings.hpp"
#include "slicing/height_field/top_surface.hpp"

namespace lamina {

/// The bend that follows the top best, as log(factor) at the corners of the cells, by least squares: where
/// the top is to be followed, it differs between neighbouring corners as log(height of the top) does, so that
/// the top is level in level layers; elsewhere, with the weight of evenness, it does not differ.
///
/// Between what is followed layers may come out too steep. There the difference of the solution is drawn to
/// what is allowed and the system solved again, up to eleven times, each time with more weight. What then
/// remains too steep is left to `limitedBend`.
/// @param is_followed  each cell
/// @throws InvalidInput if it cannot be solved
std::vector<double> fitHeightField(const TopSurface& top, const HeightGrid& cells,
                                   const std::vector<char>& is_followed, const HeightFieldSettings& settings);

}  // namespace lamina
