// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lamina {

/// Indices of the points of a chain that remain when it is simplified [Douglas1973]: its ends, and the points
/// at which it and its parts are split. Uses a stack of its own, as recursion would be as deep as the chain
/// is long.
/// @param split  (from, to): an index between the two at which to split, or `from` if no point between them
///   needs to remain
/// @return ascending indices from first to last, both included
template <class Split>
std::vector<std::size_t> keptOfChain(std::size_t first, std::size_t last, Split split) {
  std::vector<std::size_t> kept = {first};
  std::vector<std::size_t> ends;
  if (last > first) ends.push_back(last);
  while (!ends.empty()) {
    const std::size_t from = kept.back();
    const std::size_t to = ends.back();
    const std::size_t at = split(from, to);
    if (at != from) {
      ends.push_back(at);
    } else {
      kept.push_back(to);
      ends.pop_back();
    }
  }
  return kept;
}

/// Index of the point between two others of a chain that is farthest from the segment joining them; `from` if
/// none is farther than the tolerance.
/// @param at  returns the point of an index, of any dimension
template <class At>
std::size_t farthestBetween(std::size_t from, std::size_t to, double tolerance, At at) {
  const auto start = at(from);
  const decltype(start) along = at(to) - start;
  const double squared = along.squaredNorm();
  double most = tolerance;
  std::size_t farthest = from;
  for (std::size_t i = from + 1; i < to; ++i) {
    const decltype(start) offset = at(i) - start;
    const double t = squared > 0.0 ? std::clamp(offset.dot(along) / squared, 0.0, 1.0) : 0.0;
    const double distance = (offset - t * along).norm();
    if (distance > most) most = distance, farthest = i;
  }
  return farthest;
}

}  // namespace lamina
