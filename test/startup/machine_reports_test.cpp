// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/machine_reports.hpp"
#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"

#include <gtest/gtest.h>

#include "startup/large_gantry.hpp"

namespace lamina {
namespace {

class MachineReportsTest : public testing::Test {
 protected:
  static StartupSettings settings() {
    StartupSettings settings = test::largeGantry();
    settings.dry_label = "C:";
    return settings;
  }
  void read(const std::string& line, double now_s = 0.0) { reports_.read(parseReply(line), now_s); }

  MachineReports reports_{settings()};
};

TEST_F(MachineReportsTest, KnowNothingBeforeTheMachineHasSpoken) {
  read("ok");
  EXPECT_FALSE(reports_.bed() || reports_.dryer() || reports_.homed() || reports_.heights());
  EXPECT_TRUE(reports_.zones().empty());
}

TEST_F(MachineReportsTest, TakeTemperaturesPressuresAndHomedAxes) {
  read("ok T:25.00 /0.00 B:88.50 /90.00 C:79.25 /80.00 @:0 B@:0 C@:0", 7.0);
  read("zone 3: 12.5 kPa");
  read("homed: XZ");
  EXPECT_DOUBLE_EQ(reports_.bed().value_or(0.0), 88.5);
  ASSERT_TRUE(reports_.dryer());
  EXPECT_DOUBLE_EQ(reports_.dryer()->value_c, 79.25);
  EXPECT_DOUBLE_EQ(reports_.dryer()->time_s, 7.0);
  EXPECT_EQ(reports_.zones(), (std::map<int, double>{{3, 12.5}}));
  EXPECT_EQ(reports_.homed().value_or(""), "XZ");
}

TEST_F(MachineReportsTest, TakeTheHeightsOfALevelingGrid) {
  read(" 0 +9.000 +9.000");  // no grid yet
  for (const char* line :
       {"Bilinear Leveling Grid:", "      0      1", " 0 +0.100 -0.050", " 1 +0.300 +0.000", "ok"})
    read(line);
  read(" 2 +9.000 +9.000");
  ASSERT_TRUE(reports_.heights());
  EXPECT_DOUBLE_EQ(reports_.heights()->low_mm, -0.05);
  EXPECT_DOUBLE_EQ(reports_.heights()->high_mm, 0.3);
  EXPECT_EQ(reports_.heights()->points, 4U);
}

TEST_F(MachineReportsTest, ReportHowFastTheBedHeats) {
  reports_.watchBed();
  // 3 K/min for four minutes, then 6 K/min for two.
  for (int i = 0; i <= 36; ++i) {
    const double minutes = i / 6.0;
    const double bed_c = 20.0 + 3.0 * minutes + (minutes > 4.0 ? 3.0 * (minutes - 4.0) : 0.0);
    read("T:25.00 /0.00 B:" + std::to_string(bed_c) + " /90.00", 60.0 * minutes);
    if (i == 24) {
      EXPECT_NEAR(reports_.fastestBed(), 3.0, 1e-3);
    }
  }
  EXPECT_NEAR(reports_.fastestBed(), 6.0, 1e-3);
  reports_.watchBed();
  EXPECT_DOUBLE_EQ(reports_.fastestBed(), 0.0);
}

}  // namespace
}  // namespace lamina
