// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/spatial/edge_grid.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace lamina {
namespace {

using Edge = std::pair<Point2, Point2>;

double side(const Point2& a, const Point2& b, const Point2& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

bool doCross(const Edge& one, const Edge& other) {
  return side(one.first, one.second, other.first) * side(one.first, one.second, other.second) < 0.0 &&
         side(other.first, other.second, one.first) * side(other.first, other.second, one.second) < 0.0;
}

/// Short edges in a square of 10 mm.
class EdgeGridOfManyEdges : public testing::TestWithParam<double> {
 protected:
  EdgeGridOfManyEdges() {
    for (int i = 0; i < 300; ++i) {
      const Point2 from = place();
      edges_.emplace_back(from, from + 0.05 * (place() - Point2(5, 5)));
    }
  }
  Point2 place() { return {at_(random_), at_(random_)}; }

  std::mt19937 random_{7};
  std::uniform_real_distribution<double> at_{0.0, 10.0};
  std::vector<Edge> edges_;
};

TEST_P(EdgeGridOfManyEdges, FindsAllThatALineCrosses) {
  const EdgeGrid grid(edges_, GetParam());
  std::size_t crossed = 0;
  for (int i = 0; i < 200; ++i) {
    const Edge line(place(), place());
    std::set<std::size_t> found;
    grid.forCellsAlong(line.first, line.second, [&](std::size_t column, std::size_t row) {
      return grid.forEdgesIn(column, row, [&](std::size_t edge) { return found.insert(edge), true; });
    });
    for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
      if (!doCross(line, edges_[edge])) continue;
      ++crossed;
      EXPECT_EQ(found.count(edge), 1U);
    }
  }
  EXPECT_GT(crossed, 300U);
}

TEST_P(EdgeGridOfManyEdges, HasNoneBetweenPlacesOfClearNeighbours) {
  const EdgeGrid grid(edges_, GetParam());
  std::size_t clear = 0;
  for (int i = 0; i < 20000; ++i) {
    const Edge line(place(), place());
    const Edge near(line.first, line.first + 0.03 * (line.second - Point2(5, 5)));
    const auto cell = grid.clearCell(near.first);
    const auto next = grid.clearCell(near.second);
    if (!cell || !next) continue;
    if (*cell != *next && !(grid.areNeighbours(*cell, *next) && grid.isClearAround(*cell))) continue;
    ++clear;
    for (const Edge& edge : edges_) ASSERT_FALSE(doCross(near, edge));
  }
  EXPECT_GT(clear, 1000U);
}

TEST_P(EdgeGridOfManyEdges, FindsAllThatTouchABox) {
  const double cell_mm = GetParam() > 0.0 ? 10.0 / GetParam() : 1.7;
  const EdgeGrid grid(edges_, {Point2(-2, -1), Point2(11, 12)}, cell_mm);
  std::size_t touching = 0;
  for (int i = 0; i < 200; ++i) {
    const Point2 low = place();
    const Point2 high = low + 0.2 * place();
    std::set<std::size_t> found;
    grid.forEdgesNear({low, high}, [&](std::size_t edge) { found.insert(edge); });
    for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
      const auto isWithin = [&](const Point2& p) {
        return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
      };
      const Edge diagonal(low, high);
      const Edge other(Point2(low.x(), high.y()), Point2(high.x(), low.y()));
      if (!isWithin(edges_[edge].first) && !doCross(diagonal, edges_[edge]) && !doCross(other, edges_[edge]))
        continue;
      ++touching;
      EXPECT_EQ(found.count(edge), 1U);
    }
  }
  EXPECT_GT(touching, 300U);
}

INSTANTIATE_TEST_SUITE_P(Cells, EdgeGridOfManyEdges, testing::Values(0.0, 64.0));

TEST(EdgeGrid, HasNoClearCellOutside) {
  const EdgeGrid grid({{{0, 0}, {10, 0}}, {{10, 0}, {10, 10}}}, 32.0);
  EXPECT_TRUE(grid.clearCell({5, 5}));
  EXPECT_FALSE(grid.clearCell({5, 0}));
  EXPECT_FALSE(grid.clearCell({-1, 5}));
  EXPECT_FALSE(grid.clearCell({5, 20}));
  EXPECT_FALSE(EdgeGrid().clearCell({0, 0}));
  EXPECT_TRUE(EdgeGrid().isEmpty());
}

}  // namespace
}  // namespace lamina
