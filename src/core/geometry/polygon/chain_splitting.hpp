// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lamina {

/// The points of a chain that stay when it is simplified [Douglas1973]: its ends, and those at
/// which it and its parts are split. Keeps its own stack: recursion would go as deep as the chain is long.
/// @param split  (from, to): an index between them, or `from` where nothing in between has to stay
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

/// The point between two of a chain that is farthest from the segment between these; `from` if none is
/// farther than the tolerance.
/// @param at  index to point, of any dimension
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
