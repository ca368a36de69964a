// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace lamina {

/// Numbers dealt with by one task. The division does not depend on the number of threads, so sums do not.
inline constexpr std::size_t kBlock = 16384;

/// Calls body(begin, end) for the blocks of [0, count), at the same time.
template <class Body>
void forBlocks(std::size_t count, const Body& body) {
  const std::size_t blocks = (count + kBlock - 1) / kBlock;
  tbb::parallel_for(std::size_t{0}, blocks,
                    [&](std::size_t b) { body(b * kBlock, std::min(count, (b + 1) * kBlock)); });
}

/// Calls body(axis, begin, end) for the components of blocks of [0, count), at the same time.
template <class Body>
void forEntries(std::size_t count, const Body& body) {
  forBlocks(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t axis = 0; axis < 3; ++axis) body(axis, begin, end);
  });
}

/// The sum of body(axis, at) over all components of [0, count), in the same order whatever the threads.
template <class Body>
double sumOverEntries(std::size_t count, const Body& body) {
  std::vector<double> sums((count + kBlock - 1) / kBlock);
  forBlocks(count, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t at = begin; at < end; ++at) sum += body(axis, at);
    sums[begin / kBlock] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace lamina
