// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/lead_and_tilt.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/directions.hpp"

namespace lamina {
namespace {

const Point3 kDown(0, 0, -1);
const Point3 kAlongX(1, 0, 0);

TEST(LeadAndTilt, LeadLeansTheBodyForwards) {
  // The body lies against the tool axis.
  const Point3 body = -withLeadAndTilt(kDown, kAlongX, 30.0, 0.0);
  EXPECT_LE((body - Point3(0.5, 0, std::sqrt(0.75))).norm(), 1e-12);
}

TEST(LeadAndTilt, TiltLeansTheBodyToTheLeft) {
  const Point3 body = -withLeadAndTilt(kDown, kAlongX, 0.0, 30.0);
  EXPECT_LE((body - Point3(0, 0.5, std::sqrt(0.75))).norm(), 1e-12);
}

TEST(LeadAndTilt, LeadIsTakenFirstAndThenTheTangentIsTurnedAbout) {
  const double lead = 20.0 * M_PI / 180.0;
  const Point3 body = -withLeadAndTilt(kDown, kAlongX, 20.0, 90.0);
  EXPECT_LE((body - Point3(std::sin(lead), std::cos(lead), 0.0)).norm(), 1e-12);
}

TEST(LeadAndTilt, EachTurnsTheToolAxisByItsAngleWhereItIsAcrossThePath) {
  EXPECT_TRUE(rc::check([] {
    const Point3 tool_axis = test::anyToolAxis(180.0);
    const double turn = test::anyNumber(0.0, 2.0 * M_PI);
    const Point3 side = tool_axis.unitOrthogonal();
    const Point3 tangent = std::cos(turn) * side + std::sin(turn) * tool_axis.cross(side);
    const double angle = test::anyNumber(-60.0, 60.0);
    RC_ASSERT(std::abs(test::chordAngleDeg(withLeadAndTilt(tool_axis, tangent, angle, 0), tool_axis) -
                       std::abs(angle)) <= 1e-6);
    RC_ASSERT(std::abs(test::chordAngleDeg(withLeadAndTilt(tool_axis, tangent, 0, angle), tool_axis) -
                       std::abs(angle)) <= 1e-6);
    // Tilting keeps the tool across the path.
    RC_ASSERT(std::abs(withLeadAndTilt(tool_axis, tangent, 0, angle).dot(tangent)) <= 1e-12);
  }));
}

TEST(LeadAndTilt, AToolAxisAlongThePathStays) {
  EXPECT_EQ(withLeadAndTilt(kAlongX, kAlongX, 10.0, 10.0), kAlongX);
}

}  // namespace
}  // namespace lamina
