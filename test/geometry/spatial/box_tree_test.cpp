// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/spatial/box_tree.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

/// On a lattice, so that boxes touch often.
Box3 randomBox(Random& random, double longest) {
  Box3 box;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::floor(random.uniform(0.0, 10.0));
    box.high[axis] = box.low[axis] + std::floor(random.uniform(0.0, longest));
  }
  return box;
}

bool haveCommonPoint(const Box3& a, const Box3& b) {
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (a.high[axis] < b.low[axis] || b.high[axis] < a.low[axis]) return false;
  return true;
}

TEST(BoxTree, FindsTheBoxesThatOverlapOrTouchAnother) {
  EXPECT_TRUE(rc::check("as going through all of them", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    std::vector<Box3> boxes(*rc::gen::inRange<std::size_t>(0, 70));
    for (Box3& box : boxes) box = randomBox(random, 4.0);
    const Box3 asked = randomBox(random, 3.0);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      if (haveCommonPoint(boxes[i], asked)) expected.push_back(i);
    std::vector<std::uint32_t> found;
    BoxTree(boxes).visitOverlapping(asked, [&](std::uint32_t i) { found.push_back(i); });
    std::sort(found.begin(), found.end());
    RC_ASSERT(found == expected);
  }));
}

TEST(BoxTree, KeepsBoxesByTheirNumbers) {
  const BoxTree tree({{Point3(0, 0, 0), Point3(1, 1, 1)}, {Point3(5, 0, 0), Point3(6, 1, 1)}});
  EXPECT_EQ(tree.box(1).low, Point3(5, 0, 0));
}

TEST(BoxTree, FindsNothingAmongNoBoxes) {
  BoxTree({}).visitOverlapping({Point3(0, 0, 0), Point3(1, 1, 1)}, [](std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace lamina
