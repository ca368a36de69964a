// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/process_levels.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

Toolpath withValues(std::vector<ProcessValue> values) {
  Path path;
  path.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  path.values = std::move(values);
  return {"part", {{0.2, 0.2, {path}}}};
}

std::string refusalOfLevels(std::vector<ProcessValue> values) {
  try {
    requireLevels(withValues(std::move(values)), "the test");
    return {};
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

TEST(ProcessLevels, AreThoseOfTheMotionToAWaypoint) {
  const Toolpath toolpath = withValues({{"laser_power_w", AlongPath<double>({0.0, 500.0, 700.0})},
                                        {"powder_g_min", 12.0},
                                        {"something", 3.0}});
  const ProcessLevels levels = levelsTo(toolpath.layers[0].paths[0], 2);
  EXPECT_EQ(levels[ProcessLevel::LaserPower], 700.0);
  EXPECT_EQ(levels[ProcessLevel::Powder], 12.0);
  EXPECT_FALSE(levels.has(ProcessLevel::Gas) || levels.has(ProcessLevel::Fan));
}

TEST(ProcessLevels, AreEqualWhereTheyStateTheSame) {
  ProcessLevels a;
  ProcessLevels b;
  EXPECT_TRUE(a == b);
  a[ProcessLevel::Gas] = 1.0;
  EXPECT_FALSE(a == b);
  b[ProcessLevel::Gas] = 2.0;
  EXPECT_FALSE(a == b);
  b[ProcessLevel::Gas] = 1.0;
  EXPECT_TRUE(a == b);
}

TEST(ProcessLevels, OthersAndWhatIsNoAmountAreRefused) {
  EXPECT_EQ(refusalOfLevels({{"laser_power_w", 1.0},
                             {"wire_speed_mm_s", 1.0},
                             {"screw_rpm", 1.0},
                             {"powder_g_min", 1.0},
                             {"gas_l_min", 0.0}}),
            "");
  EXPECT_EQ(
      refusalOfLevels({{"wipe_share", 1.0}}),
      "toolpath layer 0, path 0: process value 'wipe_share' cannot be carried; known are laser_power_w, "
      "wire_speed_mm_s, screw_rpm, powder_g_min, gas_l_min; asked of the test");
  EXPECT_EQ(refusalOfLevels({{"gas_l_min", AlongPath<double>({1.0, -2.0, 1.0})}}),
            "toolpath layer 0, path 0: process value 'gas_l_min' is -2; must be a finite number of 0 or "
            "more; asked of the test");
}

}  // namespace
}  // namespace lamina
