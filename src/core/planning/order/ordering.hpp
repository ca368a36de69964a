// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The ends of a run, which may be run in either direction. Both are the same for a closed run.
struct RunEnds {
  Point2 first;
  Point2 last;
};

/// A run within an order, and its direction.
struct OrderedRun {
  std::size_t run = 0;
  bool is_reversed = false;
};

/// An order of the runs, with a direction for each, that has short travels. It starts from nearest
/// neighbours, and is improved by reversing and moving stretches (2-opt and or-opt) within a bounded
/// neighbourhood. Every run occurs once. The cost is about proportional to the number of runs.
///
/// @param from  place from which the nozzle comes [mm]
std::vector<OrderedRun> orderRuns(const std::vector<RunEnds>& runs, const Point2& from);

/// The same, with the travel from the last run to `to` counted too.
/// @param to  place to which the nozzle goes on [mm]; none if it does not matter
std::vector<OrderedRun> orderRuns(const std::vector<RunEnds>& runs, const Point2& from,
                                  const std::optional<Point2>& to);

/// Length of the travels of an order [mm], including the travel to the first run.
double travelLength(const std::vector<RunEnds>& runs, const std::vector<OrderedRun>& order,
                    const Point2& from);

}  // namespace lamina
