// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/runs/bead_run_settings.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/settings_schema.hpp"

namespace lamina {
namespace {

TEST(BeadRunSettings, TakeTheFormerNameOfTheToolAxis) {
  BeadRunSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  EXPECT_EQ(schema.find("entry.direction")->get(), "tool_axis");
  schema.set("entry.direction", "level");
  schema.set("entry.direction", "jet");
  EXPECT_EQ(settings.entry.direction, EntryDirection::ToolAxis);
}

TEST(BeadRunSettings, RefuseWhatCannotBeByName) {
  const auto refusal = [](const BeadRunSettings& settings) -> std::string {
    try {
      requireConsistent(settings);
    } catch (const InvalidConfig& error) {
      return error.what();
    }
    return "";
  };
  BeadRunSettings settings;
  EXPECT_EQ(refusal(settings), "");
  settings.levels.values = "laser_w=100";
  EXPECT_NE(refusal(settings).find("levels.values holds 'laser_w=100'; known are laser_power_w"),
            std::string::npos);
  settings.levels.values = "laser_power_w=from_bead";
  EXPECT_NE(refusal(settings).find("only wire_speed_mm_s"), std::string::npos);
  settings.levels.values = "laser_power_w=-1";
  EXPECT_NE(refusal(settings).find("0 or more"), std::string::npos);
  settings.levels.values = "laser_power_w=1, laser_power_w=2";
  EXPECT_NE(refusal(settings).find("each name once"), std::string::npos);
  settings.levels.values.clear();
  settings.levels.start_mm = 3.0;
  EXPECT_NE(refusal(settings).find("levels.start_mm is 3 mm"), std::string::npos);
  settings.levels = {};
  settings.lead.rise_deg = 10.0;
  settings.lead.deposit = LeadDeposit::Bead;
  EXPECT_NE(refusal(settings).find("lead.rise_deg is 10 deg"), std::string::npos);
  settings.lead.rise_deg = 0.0;
  settings.lead.overlap_mm = 8.0;
  EXPECT_EQ(refusal(settings), "") << "without leads nothing is deposited before the overlap";
  settings.lead.in = LeadShape::Line;
  EXPECT_NE(refusal(settings).find("lead.overlap_mm is 8 mm with leads that lay a bead"), std::string::npos);
  settings.lead.deposit = LeadDeposit::Dry;
  EXPECT_EQ(refusal(settings), "");
}

}  // namespace
}  // namespace lamina
