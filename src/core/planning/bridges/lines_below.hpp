// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/infill/strategy.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Directions of the lines of a sparse infill in a layer [deg, from x].
std::vector<double> linesOf(const InfillStrategy& strategy, const InfillSettings& settings,
                            std::size_t layer);

/// The direction that crosses families of equally spaced parallel lines most often per length: square to a
/// single family, 45 deg between two, square to one of three. Of equally good directions the first is taken.
/// @param lines_deg  at least one
/// @return [deg, from x]
double acrossLines(const std::vector<double>& lines_deg);

}  // namespace lamina
