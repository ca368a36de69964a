// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/order/fill_starts.hpp"
#include "planning/order/ordering.hpp"

namespace lamina {

/// Number of regions in which a bead of that plan width has room somewhere.
std::size_t regionsWithRoom(const Regions& regions, double width_mm);

/// Starts of the runs that fill an area.
/// @param deposited  in their order, as they are run
FillStarts startsOf(const Regions& area, const std::vector<RunEnds>& deposited, double pitch_mm);

}  // namespace lamina
