// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "planning/order/ordering.hpp"

namespace lamina {

/// The ends of runs in square cells, about one run a cell, from which the nearest are taken one after the
/// other.
class EndGrid {
 public:
  /// `runs` must outlive the grid.
  explicit EndGrid(const std::vector<RunEnds>& runs);

  /// The run with an end nearest to the point, entered at that end; of equally near ones the first. It is not
  /// given again. Call at most once per run.
  OrderedRun takeNearest(const Point2& point);

 private:
  struct Candidate {
    double squared_distance;
    std::uint32_t end;
  };

  std::int64_t column(double x) const;
  std::int64_t row(double y) const;
  void searchCell(std::int64_t x, std::int64_t y, const Point2& point, Candidate& best);
  void searchLoop(std::int64_t radius, const Point2& point, Candidate& best);
  const Point2& pointOf(std::uint32_t end) const;

  const std::vector<RunEnds>& runs_;
  Point2 low_;
  double cell_ = 1.0;
  std::int64_t columns_ = 1;
  std::int64_t rows_ = 1;
  std::vector<std::uint32_t> begin_;  ///< of each cell in ends_
  std::vector<std::uint32_t> count_;  ///< of each cell's ends that are left
  std::vector<std::uint32_t> ends_;   ///< 2 * run, plus 1 for its last point
  std::vector<bool> is_taken_;
};

}  // namespace lamina
