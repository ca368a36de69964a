// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace lamina {

/// Which points to keep so that they follow each other along the curve below: the greatest number of them
/// whose feet do not go back. Where walls bend, points of a contour far above may stand on the curve below
/// in another order than their own, and the curve through them would fold. Time is n log n.
///
/// @param feet_mm   length along the curve below at which each point stands
/// @param round_mm  length of that curve, if it is closed; feet then go on past its start. 0 if it is open.
/// @return ascending
std::vector<std::size_t> pointsInOrder(const std::vector<double>& feet_mm, double round_mm);

}  // namespace lamina
