// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What a look at layers that a motion cannot stop in front of costs, by the memory that it takes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <new>

#include "fed_gantry.hpp"

namespace lamina::test {
namespace {

thread_local std::size_t bytes_from_heap = 0;

}  // namespace
}  // namespace lamina::test

void* operator new(std::size_t size) {
  lamina::test::bytes_from_heap += size;
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace lamina::test {
namespace {

/// One bead that goes on from layer to layer, a turn each.
Toolpath risingSpiral(int turns) {
  constexpr int kSides = 12;
  Toolpath spiral{"spiral", {}};
  Point3 last(20.0, 0.0, 0.2);
  for (int turn = 0; turn < turns; ++turn) {
    Path path = straightPath(last, last);
    path.points = {last};
    for (int side = 1; side <= kSides; ++side) {
      const double angle = 2.0 * M_PI * side / kSides;
      last = {20.0 * std::cos(angle), 20.0 * std::sin(angle),
              0.2 + 0.2 * (turn + static_cast<double>(side) / kSides)};
      path.points.push_back(last);
    }
    spiral.layers.push_back({0.2 * (turn + 1), 0.2, {path}});
  }
  return spiral;
}

/// Taken by a hold in front of the tenth layer, that is refused.
std::size_t bytesOfHold(int turns) {
  const TimedPath timed = timedGantry(risingSpiral(turns), powderSettings());
  TrajectoryFeeder feeder(timed, {});
  const std::size_t before = bytes_from_heap;
  EXPECT_FALSE(feeder.holdAtLayer(9, 0.0));
  return bytes_from_heap - before;
}

TEST(FeederHold, ARefusedOneCostsNoMoreOnALongWay) {
  const std::size_t of_short = bytesOfHold(20);
  EXPECT_GT(of_short, 0U) << "what is taken is seen";
  EXPECT_LE(bytesOfHold(400), 2 * of_short);
}

}  // namespace
}  // namespace lamina::test
