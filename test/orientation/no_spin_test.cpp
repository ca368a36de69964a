// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/no_spin.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "support/directions.hpp"

namespace lamina {
namespace {

constexpr double kOppositeHeading = 180.0;  // the convention of [Flores2018, figure 46]

TEST(NoSpin, AVerticalToolAxisGivesTheConventionOfEitherHeading) {
  const Point3 down(0, 0, -1);
  EXPECT_EQ(noSpinFrame(down, 0.0).coeffs(), nozzleDown().coeffs());
  const Eigen::Quaterniond opposite = noSpinFrame(down, kOppositeHeading);
  EXPECT_EQ(opposite.coeffs(), Eigen::Quaterniond(0, 0, 1, 0).coeffs());
  EXPECT_EQ(opposite * Point3::UnitX(), Point3(-1, 0, 0));
  EXPECT_EQ(opposite * Point3::UnitY(), Point3(0, 1, 0));
}

TEST(NoSpin, ThePrintedQuaternionsComeBackFromTheirToolAxes) {
  const std::array<Eigen::Quaterniond, 5> printed = {
      Eigen::Quaterniond(-0.0343327, 0.0017798, 0.9980680, 0.0517530),
      Eigen::Quaterniond(-0.0340516, 0.0017715, 0.9980681, 0.0519375),
      Eigen::Quaterniond(-0.0338570, 0.0017657, 0.9980681, 0.0520640),
      Eigen::Quaterniond(0.0180419, 0.0010750, 0.9980662, -0.0594741),
      Eigen::Quaterniond(0.0183113, 0.0010895, 0.9980662, -0.0593924)};
  for (const Eigen::Quaterniond& given : printed) {
    const Point3 tool_axis = toolAxisOf(given.normalized());
    const Eigen::Quaterniond rebuilt = noSpinFrame(tool_axis, kOppositeHeading);
    EXPECT_LE((rebuilt.coeffs() - given.coeffs()).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LE(std::abs((given * Point3::UnitX()).y()), 2e-6);
    EXPECT_NEAR((rebuilt * Point3::UnitX()).y(), 0.0, 1e-15);
    EXPECT_NEAR(rebuilt.norm(), 1.0, 1e-15);
    const double tilt_deg = std::acos(-tool_axis.z()) * 180.0 / M_PI;
    EXPECT_GE(tilt_deg, 7.115);
    EXPECT_LE(tilt_deg, 7.135);
  }
}

TEST(NoSpin, TheToolAxisStaysAndTheAxisKeepsItsHeading) {
  EXPECT_TRUE(rc::check([] {
    const Point3 tool_axis = test::anyToolAxis(85.0);
    const double heading_deg = test::anyNumber(-180.0, 180.0);
    const double heading = heading_deg * M_PI / 180.0;
    const Eigen::Quaterniond frame = noSpinFrame(tool_axis, heading_deg);
    const Point3 x = frame * Point3::UnitX();
    RC_ASSERT(std::abs(frame.norm() - 1.0) <= 1e-14);
    RC_ASSERT((toolAxisOf(frame) - tool_axis).norm() <= 1e-12);
    RC_ASSERT(std::abs(x.dot(Point3(-std::sin(heading), std::cos(heading), 0.0))) <= 1e-12);
    RC_ASSERT(x.dot(Point3(std::cos(heading), std::sin(heading), 0.0)) > 0.0);
  }));
}

TEST(NoSpin, AToolAxisAcrossTheHeadingHasNoFrameOfItsOwn) {
  EXPECT_THROW(noSpinFrame(Point3(0, 1, 0), 0.0), InvalidInput);
  EXPECT_THROW(noSpinFrame(Point3(1, 0, 0), 90.0), InvalidInput);
  EXPECT_NO_THROW(noSpinFrame(Point3(1, 0, 0), 0.0));
  EXPECT_THROW(noSpinFrames({Point3(0, 1, 0), Point3(0, -1, 0)}, 0.0), InvalidInput);
}

TEST(NoSpin, AcrossTheHeadingTheAxisOfTheWaypointBeforeIsKept) {
  const std::vector<Point3> tool_axes = {Point3(0, 1, 0), Point3(0.6, 0, -0.8), Point3(0, 1, 0),
                                         Point3(0, 0, -1)};
  const std::vector<Eigen::Quaterniond> frames = noSpinFrames(tool_axes, 0.0);
  for (std::size_t i = 0; i < tool_axes.size(); ++i)
    EXPECT_LE((toolAxisOf(frames[i]) - tool_axes[i]).norm(), 1e-12);
  for (const std::size_t i : {0U, 1U, 2U})
    EXPECT_LE((frames[i] * Point3::UnitX() - Point3(0.8, 0, 0.6)).norm(), 1e-12);
}

TEST(NoSpin, SignsDoNotFlipAlongARunRoundTheSphere) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Eigen::Quaterniond> frames = noSpinFrames(test::anyToolAxes(20, 180.0), 30.0);
    for (std::size_t i = 1; i < frames.size(); ++i) RC_ASSERT(frames[i].dot(frames[i - 1]) >= 0.0);
  }));
}

}  // namespace
}  // namespace lamina
