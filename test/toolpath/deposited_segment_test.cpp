// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "toolpath/deposited_segment.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace lamina {
namespace {

using Ends = std::vector<std::pair<std::size_t, std::size_t>>;

Path triangle() {
  Path path;
  path.role = PathRole::Infill;
  path.points = {{0.0, 0.0, 1.0}, {3.0, 0.0, 1.0}, {3.0, 4.0, 1.0}};
  path.bead = AlongPath<Bead>(std::vector<Bead>{{0.4, 0.2}, {0.5, 0.2}, {0.0, 0.2}});
  return path;
}

Ends endsOf(const Path& path) {
  Ends ends;
  forEachDepositedSegment(path,
                          [&](const DepositedSegment& each) { ends.emplace_back(each.from, each.waypoint); });
  return ends;
}

TEST(DepositedSegment, IsAMotionOfABead) {
  EXPECT_EQ(endsOf(triangle()), (Ends{{0, 1}, {1, 2}}));
  std::vector<double> lengths;
  std::vector<double> widths;
  std::vector<bool> empty;
  forEachDepositedSegment(triangle(), [&](const DepositedSegment& each) {
    lengths.push_back(each.length());
    widths.push_back(each.bead.width_mm);
    empty.push_back(each.isEmpty());
  });
  EXPECT_EQ(lengths, (std::vector<double>{3.0, 4.0}));
  EXPECT_EQ(widths, (std::vector<double>{0.5, 0.0}));
  EXPECT_EQ(empty, (std::vector<bool>{false, true}));
}

TEST(DepositedSegment, OfAClosedBeadReturnsToItsStart) {
  Path path = triangle();
  path.is_closed = true;
  EXPECT_EQ(endsOf(path), (Ends{{0, 1}, {1, 2}, {2, 0}}));
}

TEST(DepositedSegment, IsADropWhereItStands) {
  Path path = triangle();
  path.deposit = Deposit::Drops;
  EXPECT_EQ(endsOf(path), (Ends{{0, 0}, {1, 1}, {2, 2}}));
}

TEST(DepositedSegment, IsNothingOfATravel) {
  Path path = triangle();
  path.role = PathRole::Travel;
  EXPECT_EQ(endsOf(path), Ends{});
}

TEST(LaysBeads, LeavesOutDropsAndTravel) {
  Path path = triangle();
  EXPECT_TRUE(laysBeads(path));
  path.role = PathRole::Skirt;
  EXPECT_TRUE(laysBeads(path));
  path.deposit = Deposit::Drops;
  EXPECT_FALSE(laysBeads(path));
  path = triangle();
  path.role = PathRole::Travel;
  EXPECT_FALSE(laysBeads(path));
}

TEST(IsPartOfPart, LeavesOutSkirtAndTravel) {
  Path path = triangle();
  EXPECT_TRUE(isPartOfPart(path));
  path.role = PathRole::Skirt;
  EXPECT_FALSE(isPartOfPart(path));
  path.role = PathRole::Travel;
  EXPECT_FALSE(isPartOfPart(path));
}

}  // namespace
}  // namespace lamina
