// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/orientation_settings.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

TEST(OrientationSettings, EveryKeyTakesItsValue) {
  OrientationSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  schema.set("orientation.mode", "wall");
  schema.set("orientation.smoothing_window", "5");
  schema.set("orientation.max_lean_deg", "30");
  schema.set("orientation.heading_deg", "180");
  EXPECT_EQ(settings.mode, OrientationMode::Wall);
  EXPECT_EQ(settings.smoothing_window, 5);
  EXPECT_EQ(settings.limits.max_lean_deg, 30.0);
  EXPECT_EQ(settings.heading_deg, 180.0);
  EXPECT_NO_THROW(schema.validate());
  EXPECT_THROW(schema.set("orientation.mode", "spinning"), InvalidConfig);
  EXPECT_THROW(schema.set("orientation.lead_deg", "61"), InvalidConfig);
}

TEST(OrientationSettings, TakeTheFormerNamesOfLean) {
  OrientationSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  schema.set("orientation.fixed_tilt_deg", "12");
  schema.set("orientation.max_tilt_deg", "34");
  EXPECT_EQ(settings.fixed.lean_deg, 12.0);
  EXPECT_EQ(settings.limits.max_lean_deg, 34.0);
}

TEST(OrientationSettings, AnEvenWindowIsRefused) {
  OrientationSettings settings;
  EXPECT_NO_THROW(requireConsistent(settings));
  settings.smoothing_window = 4;
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
}

TEST(OrientationSettings, ATurnLimitNeedsALeanLimitItCannotLeave) {
  OrientationSettings settings;
  settings.limits.max_turn_deg_per_mm = 1.0;
  EXPECT_NO_THROW(requireConsistent(settings));
  settings.limits.max_lean_deg = 120.0;
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
  settings.limits.max_lean_deg = 90.0;
  EXPECT_NO_THROW(requireConsistent(settings));
}

}  // namespace
}  // namespace lamina
