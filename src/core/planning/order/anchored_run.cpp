// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/anchored_run.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "toolpath/deposited_segment.hpp"

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

/// From a point to the nearest centre line of beads of the part; infinite without any.
double wayToBeads(const std::vector<Path>& deposited, const Point2& point) {
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (const Path& path : deposited) {
    if (!isPartOfPart(path) || path.deposit != Deposit::Bead) continue;
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const Point2 from = path.points[m].head<2>();
      const Point2 to = path.points[path.motionEnd(m)].head<2>();
      nearest_mm = std::min(nearest_mm, (nearestOnSegment(from, to, point) - point).norm());
    }
  }
  return nearest_mm;
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

FillPath begunAtBeads(FillPath run, const std::vector<Path>& deposited) {
  if (run.is_closed || run.deposit == Deposit::Drops) return run;
  const bool is_other_nearer =
      wayToBeads(deposited, run.points.back()) < wayToBeads(deposited, run.points.front());
  return is_other_nearer ? reversed(std::move(run)) : run;
}

}  // namespace lamina
