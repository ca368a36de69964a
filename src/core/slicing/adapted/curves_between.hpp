// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "slicing/adapted/growth.hpp"

namespace lamina {

/// Curves that lead from a curve to the one that was computed above it in equal steps: points by linear
/// interpolation, axes along the shortest way. Points go together by their share of the length: of closed
/// curves from the first point of the upper one and the place nearest to it; of an open one from its first
/// to its last point and from the places nearest to these.
///
/// @return as many as `parts`, the last of which is the upper curve; heights are equal shares
std::vector<AdaptedCurve> curvesBetween(const PlacedCurve& lower, const AdaptedCurve& upper,
                                        std::size_t parts);

}  // namespace lamina
