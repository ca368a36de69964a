// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/collision/deposited_tree.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

Point3 anywhere(Random& random) {
  return {random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-20, 20)};
}

/// A cube, whose size is its extent along every axis.
Extents extentsOf(const DepositedBox& box) {
  const Point3 half = 0.5 * box.size.cast<double>();
  Extents extents;
  extents.box = {box.middle - half, box.middle + half};
  extents.low_normal = extents.box.low.z();
  extents.high_normal = extents.box.high.z();
  return extents;
}

TEST(DepositedTree, FindsThoseAmongTheFirstWhoseExtentsMeetInTheOrderOfDeposition) {
  EXPECT_TRUE(rc::check("any number of boxes, any query", [](std::uint64_t seed) {
    Random random(seed);
    std::vector<DepositedBox> boxes(static_cast<std::size_t>(random.uniform(0, 300)));
    for (DepositedBox& box : boxes) {
      box.middle = anywhere(random);
      box.size.setConstant(static_cast<float>(random.uniform(0.1, 5.0)));
    }
    const DepositedTree tree(boxes, Point3::UnitZ());
    DepositedBox query;
    query.middle = anywhere(random);
    query.size.setConstant(static_cast<float>(random.uniform(0.1, 20.0)));
    const auto count = static_cast<std::size_t>(random.uniform(0, static_cast<double>(boxes.size()) + 0.99));
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < count; ++i)
      if (extentsOf(boxes[i]).meets(extentsOf(query))) expected.push_back(i);
    std::vector<std::size_t> found;
    tree.visitMeeting(extentsOf(query), count, [&](std::size_t box, const Extents&) {
      found.push_back(box);
      return false;
    });
    RC_ASSERT(found == expected);
  }));
}

TEST(DepositedTree, StopsWhenTheVisitSaysSo) {
  std::vector<DepositedBox> boxes(50);
  for (DepositedBox& box : boxes) box.size.setConstant(1.0F);
  int visits = 0;
  DepositedTree(boxes, Point3::UnitZ())
      .visitMeeting(extentsOf(boxes[0]), boxes.size(),
                    [&](std::size_t, const Extents&) { return ++visits == 7; });
  EXPECT_EQ(visits, 7);
}

}  // namespace
}  // namespace lamina
