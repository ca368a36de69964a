// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run_stretches.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <vector>

namespace lamina {
namespace {

std::set<std::size_t> cellsOf(const CellRun& run, const CellStretch& stretch) {
  std::set<std::size_t> cells;
  for (std::size_t i = 0; i < stretch.count; ++i) cells.insert(cellOf(run, stretch, i));
  return cells;
}

TEST(RunStretches, AroundACellIsTheOneThatHoldsIt) {
  EXPECT_TRUE(rc::check([] {
    const auto joined = *rc::gen::container<std::vector<bool>>(*rc::gen::inRange<std::size_t>(1, 12),
                                                               rc::gen::arbitrary<bool>());
    const CellRun run{0, 5, joined.size(), 1.0, *rc::gen::arbitrary<bool>()};
    // Cell i and the next one belong together if joined[i].
    const auto belongs = [&](std::size_t cell, std::size_t) { return joined[cell - run.first]; };
    for (const CellStretch& whole : stretchesOf(run, belongs))
      for (const std::size_t cell : cellsOf(run, whole)) {
        const CellStretch around = stretchAround(run, cell, belongs);
        RC_ASSERT(cellsOf(run, around) == cellsOf(run, whole));
        // All cells of a closed run that belong together have no first one, unless a pair is apart.
        if (whole.count < run.count || !run.is_closed) RC_ASSERT(around.first == whole.first);
      }
  }));
}

}  // namespace
}  // namespace lamina
