// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/order/fill_starts.hpp"
#include "planning/order/ordering.hpp"

namespace lamina {

/// Number of regions with room for a bead of that width somewhere.
std::size_t regionsWithRoom(const Regions& regions, double width_mm);

/// The starts and travels of the runs that fill an area.
/// @param deposited  ends of the runs in the order of deposition
FillStarts startsOf(const Regions& area, const std::vector<RunEnds>& deposited, double pitch_mm);

}  // namespace lamina
