// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Where a run starts and ends; it may be run either way. Both the same for a closed one.
struct RunEnds {
  Point2 first;
  Point2 last;
};

/// A run in its place of the order.
struct OrderedRun {
  std::size_t run = 0;
  bool is_reversed = false;
};

/// An order of the runs, and a direction for each, with short travels between them [mm]: nearest neighbour
/// first, then improved by turning round and moving stretches of it (2-opt and or-opt) within a bounded
/// neighbourhood. Every run stands in it once. The effort grows about linearly with the number of runs.
///
/// @param from  where the nozzle comes from
std::vector<OrderedRun> orderRuns(const std::vector<RunEnds>& runs, const Point2& from);

/// Length of the travels of that order [mm], the one to its first run included.
double travelLength(const std::vector<RunEnds>& runs, const std::vector<OrderedRun>& order,
                    const Point2& from);

}  // namespace lamina
