// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/point_order.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace lamina {
namespace {

using Numbers = std::vector<std::size_t>;

TEST(PointOrder, PointsInOrderAreKept) {
  EXPECT_EQ(pointsInOrder({0.0, 1.0, 1.0, 2.5}, 0.0), (Numbers{0, 1, 2, 3}));
  EXPECT_EQ(pointsInOrder({7.0, 9.0, 1.0, 3.0}, 10.0), (Numbers{0, 1, 2, 3}));
  EXPECT_TRUE(pointsInOrder({}, 0.0).empty());
}

TEST(PointOrder, APointThatGoesBackIsLeftOut) {
  EXPECT_EQ(pointsInOrder({0.0, 1.0, 0.5, 2.0, 3.0}, 0.0).size(), 4U);
  EXPECT_EQ(pointsInOrder({0.0, 1.0, 9.0, 2.0, 3.0}, 0.0), (Numbers{0, 1, 3, 4}));
}

TEST(PointOrder, NoLongerRunIsInOrder) {
  EXPECT_TRUE(rc::check([] {
    const auto feet = *rc::gen::container<std::vector<int>>(12, rc::gen::inRange(0, 10));
    const Numbers kept = pointsInOrder(std::vector<double>(feet.begin(), feet.end()), 0.0);
    for (std::size_t i = 1; i < kept.size(); ++i) RC_ASSERT(feet[kept[i - 1]] <= feet[kept[i]]);
    // The longest run that ends at each point, by looking at all before it.
    std::size_t longest = 0;
    Numbers length(feet.size(), 1);
    for (std::size_t i = 0; i < feet.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        if (feet[j] <= feet[i]) length[i] = std::max(length[i], length[j] + 1);
      longest = std::max(longest, length[i]);
    }
    RC_ASSERT(kept.size() == longest);
  }));
}

}  // namespace
}  // namespace lamina
