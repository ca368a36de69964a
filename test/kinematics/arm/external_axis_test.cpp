// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/arm/external_axis.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "support/directions.hpp"

namespace lamina {
namespace {

/// A tool axis that leans by 20 deg.
Point3 leaning(double heading) {
  const double tilt = 20.0 * M_PI / 180.0;
  return {std::sin(tilt) * std::cos(heading), std::sin(tilt) * std::sin(heading), -std::cos(tilt)};
}

TEST(ExternalAxis, TheTableTurnsAgainstTheHeadingOfTheToolAxis) {
  // The table stands before the robot: away from it is x of the base, and of the bed with the table at zero.
  const auto arm = kinematicModelByName("irb_4600_turntable");
  EXPECT_NEAR(tableValue(*arm, leaning(0.0), {}, 0.0), 0.0, 1e-12);
  EXPECT_NEAR(tableValue(*arm, leaning(0.5), {}, 0.0), -0.5, 1e-12);
  EXPECT_NEAR(tableValue(*arm, leaning(0.5), {1.5}, 0.0), 1.0, 1e-12);
  EXPECT_NEAR(toolAxisAzimuth(*arm, leaning(0.5), 1.0), 1.5, 1e-12);
}

TEST(ExternalAxis, TheToolAxesOfATiltedWallAllGoOneWayOverTheBase) {
  const auto arm = kinematicModelByName("irb_4600_turntable");
  double table = 0.0;
  for (int step = 0; step <= 1000; ++step) {
    const double heading = 4.0 * M_PI * step / 1000.0;
    const Point3 tool_axis = leaning(heading);
    table = tableValue(*arm, tool_axis, {M_PI / 3.0}, table);
    JointValues values = JointValues::Zero(7);
    values[6] = table;
    const auto links = arm->bedFromLinks(values);
    const Point3 over_base = links.at("base_link").linear().transpose() * tool_axis;
    EXPECT_NEAR(std::atan2(over_base.y(), over_base.x()), M_PI / 3.0, 1e-12);
    // Two turns of the wall are two turns of the table, without a jump.
    EXPECT_NEAR(table, M_PI / 3.0 - heading, 1e-9);
  }
}

TEST(ExternalAxis, TheValueIsTheNearestThatHasTheAzimuth) {
  const auto arm = kinematicModelByName("irb_4600_turntable");
  EXPECT_TRUE(rc::check([&] {
    const Point3 tool_axis = test::anyToolAxis(80.0);
    RC_PRE(tool_axis.head<2>().norm() > 1e-6);
    const double near = test::anyNumber(-50.0, 50.0);
    const double azimuth = test::anyNumber(-3.0, 3.0);
    const double table = tableValue(*arm, tool_axis, {azimuth}, near);
    RC_ASSERT(std::abs(table - near) <= M_PI + 1e-9);
    RC_ASSERT(std::abs(toolAxisAzimuth(*arm, tool_axis, table) - azimuth) < 1e-9);
  }));
}

TEST(ExternalAxis, AToolAxisAlongTheAxisLeavesTheTableWhereItIs) {
  const auto arm = kinematicModelByName("irb_4600_turntable");
  EXPECT_EQ(tableValue(*arm, -Point3::UnitZ(), {1.0}, 7.5), 7.5);
}

TEST(ExternalAxis, AnArmWithoutATableIsRefused) {
  EXPECT_THROW(tableValue(*kinematicModelByName("irb_4600"), -Point3::UnitZ(), {}, 0.0), InvalidConfig);
  EXPECT_THROW(tableValue(*kinematicModelByName("cartesian_gantry"), -Point3::UnitZ(), {}, 0.0),
               InvalidConfig);
}

}  // namespace
}  // namespace lamina
