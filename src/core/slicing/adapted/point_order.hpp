// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace lamina {

/// Indices of the points to keep so that they follow each other along the curve below: the greatest number of
/// points whose feet on that curve ascend. Where a wall bends, points of a contour far above may have their
/// feet in another order than their own, and a curve through all of them would fold. Takes time of order n
/// log n.
///
/// @param feet_mm   length along the curve below at which the foot of each point lies
/// @param round_mm  length of that curve if it is closed, in which case feet continue past its start; 0 if it
///   is open
/// @return ascending
std::vector<std::size_t> pointsInOrder(const std::vector<double>& feet_mm, double round_mm);

}  // namespace lamina
