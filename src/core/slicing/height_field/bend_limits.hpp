// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/slicing/height_field/height_field.hpp"
#include "lamina/slicing/height_field/height_field_settings.hpp"
#include "slicing/height_field/top_surface.hpp"

namespace lamina {

/// Thinnest and thickest of a bent layer where there is material, in layer heights.
struct FactorRange {
  double least = 1.0;
  double greatest = 1.0;
};
FactorRange factorRange(const HeightField& field, const TopSurface& top);

/// Tangent of the steepest slope of any layer where there is material: at most so steep.
double steepestSlope(const HeightField& field, const TopSurface& top);

/// The same in one half of a cell; 0 where there is no material.
/// @param factor  at the corners of the cells
double steepestSlope(const std::vector<double>& factor, const HeightGrid& cells, const TopSurface& top,
                     std::size_t half);

/// A bend within its limits, and which part of the asked one it is.
struct LimitedBend {
  HeightField field;
  double share = 1.0;
};

/// The bend times the greatest share with which slope and thickness keep within their limits everywhere where
/// there is material. Layers keep their height on average there, as far as the limits allow.
/// @param log_factor  at the corners of the cells
LimitedBend limitedBend(HeightGrid cells, double base_mm, const std::vector<double>& log_factor,
                        const TopSurface& top, const HeightFieldSettings& settings);

}  // namespace lamina
