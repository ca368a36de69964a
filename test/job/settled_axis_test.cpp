// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/settled_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/angle.hpp"
#include "planning/nozzle_frame.hpp"

namespace lamina {
namespace {

constexpr double kHalfRad = toRadians(1.0);

Point3 leaningBy(double tilt_deg, double heading_deg) {
  const double tilt = toRadians(tilt_deg);
  const double heading = toRadians(heading_deg);
  return {std::sin(tilt) * std::cos(heading), std::sin(tilt) * std::sin(heading), std::cos(tilt)};
}

TEST(SettledAxis, IsUprightWithinTheAngleAndStaysBeyondTwiceThat) {
  EXPECT_EQ(settledAxis(leaningBy(0.99, 70.0), kHalfRad), Point3::UnitZ());
  EXPECT_NEAR((settledAxis(leaningBy(1.5, 70.0), kHalfRad) - leaningBy(1.0, 70.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(settledAxis(leaningBy(2.01, 70.0), kHalfRad), leaningBy(2.01, 70.0));
  EXPECT_EQ(settledAxis(Point3::UnitZ(), kHalfRad), Point3::UnitZ());
  EXPECT_EQ(settledAxis(Point3::UnitX(), kHalfRad), Point3::UnitX());
}

TEST(SettledAxis, TurnsNoneByMoreThanTheAngleAndJumpsNowhere) {
  Point3 before = Point3::UnitZ();
  for (int i = 0; i <= 400; ++i) {
    const Point3 axis = leaningBy(0.01 * i, 30.0);
    const Point3 settled = settledAxis(axis, kHalfRad);
    EXPECT_LE(std::acos(std::min(1.0, settled.dot(axis))), kHalfRad + 1e-7) << i;
    EXPECT_LE((settled - before).norm(), toRadians(0.021)) << i;
    before = settled;
  }
}

TEST(SettledAxis, OfAToolpathChangesOnlyWhatIsNearlyUpright) {
  Path path;
  path.points = {{0, 0, 1}, {1, 0, 1}, {2, 0, 1}};
  const Eigen::Quaterniond far = nozzleAgainst(leaningBy(20.0, 10.0));
  path.orientation = AlongPath<Eigen::Quaterniond>(
      {far, nozzleAgainst(leaningBy(0.5, 10.0)), nozzleAgainst(leaningBy(0.5, 200.0))});
  Path level = path;
  level.orientation = nozzleAgainst(leaningBy(0.3, 90.0));
  Toolpath toolpath;
  toolpath.layers.resize(1);
  toolpath.layers[0].paths = {path, level};
  settleAxes(toolpath, kHalfRad);
  const auto& settled = toolpath.layers[0].paths[0].orientation;
  EXPECT_EQ(settled.at(0).coeffs(), far.coeffs());
  for (const std::size_t i : {1U, 2U})
    EXPECT_EQ(settled.at(i).coeffs(), nozzleAgainst(Point3::UnitZ()).coeffs());
  EXPECT_TRUE(toolpath.layers[0].paths[1].orientation.isCommon());
  EXPECT_EQ(toolpath.layers[0].paths[1].orientation.at(0).coeffs(), nozzleAgainst(Point3::UnitZ()).coeffs());
}

}  // namespace
}  // namespace lamina
