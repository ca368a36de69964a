// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "startup/startup_code.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "startup/large_gantry.hpp"

namespace lamina {
namespace {

/// Seconds of all G4 of a code.
double dwellOf(const std::string& code) {
  std::istringstream lines(code);
  double milliseconds = 0.0;
  for (std::string line; std::getline(lines, line);)
    if (line.compare(0, 4, "G4 P") == 0) milliseconds += std::stod(line.substr(4));
  return 1e-3 * milliseconds;
}

TEST(StartupCode, RaisesTheBedFrom20To90DegreesInTheTimeOfTheProcedure) {
  // [Garcia2024, section 3.5]: at 3 K/min, 20 to 90 degrees take 23.3 min. The last kelvin is not
  // waited for.
  const std::string ramp = bedRamp(test::largeGantry(), 20.0);
  EXPECT_NEAR(dwellOf(ramp) / 60.0, 70.0 / 3.0 - 1.0 / 3.0, 1e-9);
  EXPECT_EQ(ramp.substr(0, 9), "M140 S21\n");
  EXPECT_EQ(ramp.substr(ramp.size() - 9), "M140 S90\n");
}

TEST(StartupCode, OnlySetsTheTargetOfABedThatIsHotAlready) {
  EXPECT_EQ(bedRamp(test::largeGantry(), 90.0), "M140 S90\n");
  EXPECT_EQ(bedRamp(test::largeGantry(), 120.0), "M140 S90\n");
}

TEST(StartupCode, WaitsInPieces) {
  EXPECT_EQ(dwell(12.5), "G4 P5000\nG4 P5000\nG4 P2500\n");
  EXPECT_EQ(dwell(0.0), "");
}

TEST(StartupCode, SwitchesEveryZone) {
  StartupSettings settings = test::largeGantry();
  settings.vacuum_zones = "2 4";
  EXPECT_EQ(vacuumOn(settings), "M42 P2 S255\nM42 P4 S255\n");
  EXPECT_EQ(vacuumOffCommands(settings), (std::vector<std::string>{"M42 P2 S0", "M42 P4 S0"}));
}

}  // namespace
}  // namespace lamina
