// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/spatial/box_cells.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "geometry/boxes.hpp"
#include "lamina/base/random.hpp"

namespace lamina {
namespace {

Point3 randomPoint(Random& random, double low, double high) {
  return {random.uniform(low, high), random.uniform(low, high), random.uniform(low, high)};
}

std::vector<Box3> randomBoxes(Random& random) {
  std::vector<Box3> boxes(80);
  for (Box3& box : boxes) {
    box.low = randomPoint(random, 0.0, 10.0);
    box.high = box.low + randomPoint(random, 0.0, 3.0);
  }
  return boxes;
}

/// Two boxes of each number.
BoxCells cellsOf(const std::vector<Box3>& boxes, CellKind kind, double cell_mm) {
  const CellSpace space{kind, {Point3(0, 0, 0), Point3(13, 13, 13)}, cell_mm};
  return BoxCells(space, [&](const auto& put) {
    for (std::uint32_t i = 0; i < boxes.size(); ++i) put(i / 2, boxes[i]);
  });
}

class BoxCellsOfKind : public testing::TestWithParam<CellKind> {};

TEST_P(BoxCellsOfKind, FindTheBoxesThatHoldAPlace) {
  EXPECT_TRUE(rc::check("none less than by going through all of them", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const std::vector<Box3> boxes = randomBoxes(random);
    const BoxCells cells = cellsOf(boxes, GetParam(), random.uniform(0.2, 4.0));
    const Point3 place = randomPoint(random, 0.0, 13.0);
    const BoxCells::Numbers near = cells.near(place);
    RC_ASSERT(std::is_sorted(near.begin(), near.end()));
    RC_ASSERT(std::adjacent_find(near.begin(), near.end()) == near.end());
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      if (isInBox(boxes[i], place)) RC_ASSERT(std::binary_search(near.begin(), near.end(), i / 2));
  }));
}

TEST_P(BoxCellsOfKind, FindNoBoxOfAnotherCell) {
  const BoxCells cells = cellsOf({{Point3(1.2, 1.2, 1.2), Point3(1.8, 1.8, 1.8)}}, GetParam(), 1.0);
  EXPECT_EQ(cells.near({1.1, 1.1, 1.1}).end() - cells.near({1.1, 1.1, 1.1}).begin(), 1);
  EXPECT_EQ(cells.near({2.1, 1.1, 1.1}).end() - cells.near({2.1, 1.1, 1.1}).begin(), 0);
  EXPECT_EQ(cells.near({1.1, 1.1, 5.0}).end() - cells.near({1.1, 1.1, 5.0}).begin(),
            GetParam() == CellKind::Squares ? 1 : 0);
}

TEST_P(BoxCellsOfKind, FindNothingOutside) {
  const BoxCells cells = cellsOf({{Point3(0, 0, 0), Point3(13, 13, 13)}}, GetParam(), 1.0);
  EXPECT_EQ(cells.cellAt({-0.1, 5, 5}), BoxCells::kNone);
  EXPECT_EQ(cells.cellAt({5, 14.5, 5}), BoxCells::kNone);
  EXPECT_EQ(cells.in(BoxCells::kNone).begin(), cells.in(BoxCells::kNone).end());
}

INSTANTIATE_TEST_SUITE_P(Kinds, BoxCellsOfKind, testing::Values(CellKind::Squares, CellKind::Cubes));

TEST(BoxCells, HoldPairsThatOverlapInACommonCell) {
  Random random(11);
  const std::vector<Box3> boxes = randomBoxes(random);
  const CellSpace space{CellKind::Cubes, {Point3(0, 0, 0), Point3(13, 13, 13)}, 1.5};
  const BoxCells cells(space, [&](const auto& put) {
    for (std::uint32_t i = 0; i < boxes.size(); ++i) put(i, boxes[i]);
  });
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (std::uint32_t j = 0; j < i; ++j) {
      if (!areOverlapping(boxes[i], boxes[j])) continue;
      bool is_found = false;
      for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
        const BoxCells::Numbers in = cells.in(cell);
        is_found |=
            std::binary_search(in.begin(), in.end(), i) && std::binary_search(in.begin(), in.end(), j);
      }
      EXPECT_TRUE(is_found) << i << " and " << j;
    }
}

}  // namespace
}  // namespace lamina
