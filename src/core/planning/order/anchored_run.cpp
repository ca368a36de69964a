// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/anchored_run.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace lamina {
namespace {

/// Waypoints first, first + 1, ..., last; of a closed run modulo their number.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
  double length_mm = 0.0;
};

/// The longest stretch of carried waypoints of a run whose first waypoint is not carried.
std::optional<Stretch> longestCarried(const FillPath& run,
                                      const std::function<bool(const Point2&)>& carries) {
  std::optional<Stretch> longest;
  std::optional<Stretch> current;
  for (std::size_t i = 1; i < run.points.size(); ++i) {
    if (!carries(run.points[i])) {
      current.reset();
      continue;
    }
    if (current) {
      current->length_mm += (run.points[i] - run.points[i - 1]).norm();
      current->last = i;
    } else {
      current = Stretch{i, i, 0.0};
    }
    if (!longest || current->length_mm > longest->length_mm) longest = current;
  }
  return longest;
}

FillPath startedAt(FillPath loop, std::size_t start) {
  const auto offset = static_cast<std::ptrdiff_t>(start);
  std::rotate(loop.points.begin(), loop.points.begin() + offset, loop.points.end());
  if (!loop.width_mm.empty())
    std::rotate(loop.width_mm.begin(), loop.width_mm.begin() + offset, loop.width_mm.end());
  return loop;
}

FillPath piece(const FillPath& run, std::size_t first, std::size_t last) {
  const auto from = static_cast<std::ptrdiff_t>(first);
  const auto to = static_cast<std::ptrdiff_t>(last) + 1;
  FillPath part = run;
  part.points.assign(run.points.begin() + from, run.points.begin() + to);
  if (!run.width_mm.empty()) part.width_mm.assign(run.width_mm.begin() + from, run.width_mm.begin() + to);
  return part;
}

}  // namespace

std::vector<FillPath> anchored(FillPath run, const std::function<bool(const Point2&)>& carries) {
  if (run.deposit == Deposit::Drops || carries(run.points.front())) return {std::move(run)};
  if (!run.is_closed && carries(run.points.back())) return {reversed(std::move(run))};
  const std::optional<Stretch> carried = longestCarried(run, carries);
  if (!carried) return {std::move(run)};
  if (run.is_closed) return {startedAt(std::move(run), carried->first)};
  const std::size_t middle = (carried->first + carried->last) / 2;
  return {reversed(piece(run, 0, middle)), piece(run, middle, run.points.size() - 1)};
}

}  // namespace lamina
