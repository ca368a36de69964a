// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/lattice/lattice_walk.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;
using test::reversed;

std::vector<LatticeWalk> walksOver(const Lattice& lattice) {
  return walkLattice(lattice, makeTours(lattice));
}

bool leads(const Lattice& lattice, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t low = std::min(a, b);
  const std::uint32_t step = std::max(a, b) - low;
  if (step == 1) return lattice.leadsRight(low);
  return step == static_cast<std::uint32_t>(lattice.frame.columns()) && lattice.leadsUp(low);
}

/// Labels of the connected parts of the lattice; cells outside have none.
std::map<std::uint32_t, std::uint32_t> parts(const Lattice& lattice) {
  std::map<std::uint32_t, std::uint32_t> label;
  for (std::uint32_t root = 0; root < lattice.size(); ++root) {
    if (!lattice.isInside(root) || label.count(root) != 0) continue;
    std::vector<std::uint32_t> open = {root};
    label[root] = root;
    while (!open.empty()) {
      const std::uint32_t cell = open.back();
      open.pop_back();
      const auto stride = static_cast<std::uint32_t>(lattice.frame.columns());
      for (const std::uint32_t next : {cell + 1, cell - 1, cell + stride, cell - stride})
        if (next < lattice.size() && leads(lattice, cell, next) && label.emplace(next, root).second)
          open.push_back(next);
    }
  }
  return label;
}

TEST(LatticeWalk, OverASquareIsOneTourWithoutRepetition) {
  for (const int side : {2, 4, 16, 31}) {
    const Lattice lattice({rectangle(0, 0, side - 0.9, side - 0.9), {}}, 1.0, 0.0);
    const std::vector<LatticeWalk> walks = walksOver(lattice);
    ASSERT_EQ(walks.size(), 1U);
    EXPECT_TRUE(walks[0].is_closed);
    const std::set<std::uint32_t> distinct(walks[0].cells.begin(), walks[0].cells.end());
    EXPECT_EQ(distinct.size(), static_cast<std::size_t>(side * side));
    // An odd number of cells has no Hamiltonian cycle: one cell at least is reached there and back.
    EXPECT_LE(walks[0].cells.size(), distinct.size() + (side % 2));
  }
}

TEST(LatticeWalk, OverARowOfCellsGoesOnceFromEndToEnd) {
  const Lattice lattice({rectangle(0, 0, 10, 0.3), {}}, 1.0, 0.0);
  const std::vector<LatticeWalk> walks = walksOver(lattice);
  ASSERT_EQ(walks.size(), 1U);
  EXPECT_FALSE(walks[0].is_closed);
  EXPECT_EQ(walks[0].cells.size(), 11U);
  for (const bool is_doubled : walks[0].is_doubled) EXPECT_FALSE(is_doubled);
}

TEST(LatticeWalk, PassesANeckThereAndBack) {
  const Polygon dumbbell = {{0, 0},      {5.1, 0}, {5.1, 1.8}, {9, 1.8},   {9, 0},     {14.1, 0},
                            {14.1, 5.1}, {9, 5.1}, {9, 2.6},   {5.1, 2.6}, {5.1, 5.1}, {0, 5.1}};
  const Lattice lattice({dumbbell, {}}, 1.0, 0.0);
  const std::vector<LatticeWalk> walks = walksOver(lattice);
  ASSERT_EQ(walks.size(), 1U);
  EXPECT_TRUE(walks[0].is_closed);
  // From x = 5 to x = 9, one row high: four steps, each there and back.
  EXPECT_GE(std::count(walks[0].is_doubled.begin(), walks[0].is_doubled.end(), true), 8);
}

TEST(LatticeWalk, VisitsEveryCellOfEachPartByStepsInTheRegion) {
  EXPECT_TRUE(rc::check("random regions", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Region region{test::star(random, {1, 2}, 5.0, 12.0, 24),
                        {reversed(test::star(random, {1, 2}, 1.0, 4.0, 12))}};
    const Lattice lattice(region, random.uniform(0.4, 3.0), random.uniform(-4, 4));
    const std::map<std::uint32_t, std::uint32_t> label = parts(lattice);
    std::map<std::uint32_t, std::size_t> cells_of;
    for (const auto& [cell, part] : label) ++cells_of[part];
    std::set<std::uint32_t> walked;
    for (const LatticeWalk& walk : walksOver(lattice)) {
      RC_ASSERT(walk.cells.size() == walk.is_doubled.size());
      RC_ASSERT(walked.insert(label.at(walk.cells[0])).second);
      const std::set<std::uint32_t> distinct(walk.cells.begin(), walk.cells.end());
      RC_ASSERT(distinct.size() == cells_of[label.at(walk.cells[0])]);
      for (std::size_t i = walk.is_closed ? 0 : 1; i < walk.cells.size(); ++i)
        RC_ASSERT(leads(lattice, walk.cells[i == 0 ? walk.cells.size() - 1 : i - 1], walk.cells[i]));
    }
    for (const auto& [part, count] : cells_of) RC_ASSERT(count == 1 || walked.count(part) == 1);
  }));
}

TEST(LatticeWalk, TakesDiagonalStepsOnceTheyAreFound) {
  // Two squares of cells that meet at a corner, by a slanted neck too narrow for a straight step.
  const Polygon pair = {{0, 0},     {3.1, 0}, {3.1, 2.9}, {4.3, 4.1}, {7.1, 4.1},
                        {7.1, 7.1}, {4, 7.1}, {4, 4.3},   {2.8, 3.1}, {0, 3.1}};
  Lattice lattice({pair, {}}, 1.0, 0.0);
  const LatticeTours tours = makeTours(lattice);
  ASSERT_EQ(walkLattice(lattice, tours).size(), 2U);
  lattice.findDiagonals();
  const std::vector<LatticeWalk> walks = walkLattice(lattice, tours);
  ASSERT_EQ(walks.size(), 1U);
  EXPECT_TRUE(walks[0].is_closed);
}

TEST(LatticeWalk, RepeatsFewCells) {
  const Lattice lattice({test::circle({0, 0}, 30, 200), {reversed(test::circle({3, 4}, 9, 80))}}, 0.5, 0.3);
  const std::vector<LatticeWalk> walks = walksOver(lattice);
  ASSERT_EQ(walks.size(), 1U);
  const auto doubled = std::count(walks[0].is_doubled.begin(), walks[0].is_doubled.end(), true);
  EXPECT_LT(static_cast<double>(doubled), 0.03 * static_cast<double>(walks[0].cells.size()));
}

}  // namespace
}  // namespace lamina
