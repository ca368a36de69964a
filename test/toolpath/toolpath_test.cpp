// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/toolpath.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

TEST(Path, OfTwoPointsHasOneMotionAndTwoIfClosed) {
  Path path = test::straightPath({0, 0, 0}, {3, 4, 0});
  EXPECT_EQ(path.motionCount(), 1U);
  EXPECT_DOUBLE_EQ(length(path), 5.0);
  EXPECT_EQ(path.lastPoint(), Point3(3, 4, 0));
  path.is_closed = true;
  EXPECT_EQ(path.motionCount(), 2U);
  EXPECT_EQ(path.motionEnd(1), 0U);
  EXPECT_DOUBLE_EQ(length(path), 10.0);
  EXPECT_EQ(path.lastPoint(), Point3(0, 0, 0));
}

TEST(Path, WithoutPointsHasNoMotion) {
  EXPECT_EQ(Path{}.motionCount(), 0U);
  EXPECT_EQ(length(Path{}), 0.0);
}

TEST(CrossSection, IsTheAreaOfAStadium) {
  EXPECT_DOUBLE_EQ(crossSection({0.4, 0.2}), 0.2 * 0.2 + M_PI * 0.01);
  EXPECT_DOUBLE_EQ(crossSection({0.2, 0.4}), crossSection({0.4, 0.2}));
  EXPECT_DOUBLE_EQ(crossSection({0.5, 0.5}), M_PI * 0.0625);
  EXPECT_DOUBLE_EQ(crossSection({0.0, 0.2}), 0.0);
}

TEST(DepositedVolume, OfACommonBeadIsLengthTimesCrossSection) {
  EXPECT_DOUBLE_EQ(depositedVolume(test::straightPath({0, 0, 0}, {10, 0, 0})),
                   10.0 * crossSection({0.4, 0.2}));
}

TEST(DepositedVolume, OfAVaryingBeadCountsEachMotionWithTheBeadAtItsEnd) {
  Path path = test::straightPath({0, 0, 0}, {1, 0, 0});
  path.points.emplace_back(1, 2, 0);
  path.bead = AlongPath<Bead>(std::vector<Bead>{{9.0, 0.2}, {0.4, 0.2}, {0.8, 0.2}});
  EXPECT_DOUBLE_EQ(depositedVolume(path), 1.0 * crossSection({0.4, 0.2}) + 2.0 * crossSection({0.8, 0.2}));
  path.is_closed = true;
  EXPECT_GT(depositedVolume(path), std::sqrt(5.0) * crossSection({9.0, 0.2}));
}

TEST(DepositedVolume, OfATravelIsNothing) {
  Path path = test::straightPath({0, 0, 0}, {1, 0, 0});
  path.role = PathRole::Travel;
  EXPECT_EQ(depositedVolume(path), 0.0);
}

TEST(AlongPath, HoldsOneValueForAllOrOnePerWaypoint) {
  const AlongPath<double> common(3.0);
  EXPECT_TRUE(common.isCommon());
  EXPECT_EQ(common.at(77), 3.0);
  const AlongPath<double> each(std::vector<double>{1.0, 2.0});
  EXPECT_FALSE(each.isCommon());
  EXPECT_EQ(each.at(1), 2.0);
}

TEST(Totals, AddUpDepositionAndTravelApart) {
  const ToolpathTotals sum = totals(test::twoLayers());
  EXPECT_EQ(sum.layers, 2U);
  EXPECT_EQ(sum.waypoints, 4U + 2U + 2U);
  EXPECT_EQ(sum.deposition_runs, 2U);
  EXPECT_DOUBLE_EQ(sum.deposition_mm, 40.0 + 10.0);
  EXPECT_DOUBLE_EQ(sum.travel_mm, 0.2);
  EXPECT_DOUBLE_EQ(sum.deposited_mm3, 50.0 * crossSection({0.4, 0.2}));
}

TEST(Totals, OfNothingAreNothing) { EXPECT_EQ(totals({}).waypoints, 0U); }

TEST(DepositionBox, LeavesTravelsOut) {
  Toolpath toolpath = test::twoLayers();
  toolpath.layers[0].paths[1].points[1].x() = -50.0;
  EXPECT_EQ(depositionBox(toolpath).low, Point3(0, 0, 0.2));
  EXPECT_EQ(depositionBox(toolpath).high, Point3(10, 10, 0.4));
  EXPECT_TRUE(depositionBox({}).isEmpty());
}

TEST(PathRole, GoesThroughItsName) {
  for (int i = 0; i <= static_cast<int>(PathRole::Travel); ++i)
    EXPECT_EQ(pathRoleFromString(toString(static_cast<PathRole>(i))), static_cast<PathRole>(i));
  EXPECT_THROW(pathRoleFromString("outer wall"), InvalidInput);
}

TEST(NozzleDown, TurnsTheToolAxisAgainstZAndKeepsX) {
  EXPECT_TRUE((nozzleDown() * Point3::UnitZ()).isApprox(-Point3::UnitZ()));
  EXPECT_TRUE((nozzleDown() * Point3::UnitX()).isApprox(Point3::UnitX()));
}

}  // namespace
}  // namespace lamina
