// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/gcode/laid_filament.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

namespace lamina {
namespace {

constexpr double kArea = M_PI;  // mm^2 of filament 2 mm thick

void take(LaidFilament& laid, const std::string& program) {
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) laid.take(line);
}

TEST(LaidFilament, CountsBeadsAndTheFilamentThatLeavesTheNozzle) {
  LaidFilament laid(2.0);
  EXPECT_EQ(laid.length(), 0.0);
  EXPECT_EQ(laid.feed(), 0.0);
  take(laid, "G28\nG92 E0\nG1 E5 F300");
  EXPECT_EQ(laid.length(), 0.0);
  EXPECT_NEAR(laid.volume(), 5.0 * kArea, 1e-9) << "a purge is material, and no bead";
  take(laid, "G0 X10 Y0 F6000\nG1 X40 Y40 E7.5 F1800");
  EXPECT_NEAR(laid.length(), 50.0, 1e-9);
  EXPECT_NEAR(laid.volume(), 7.5 * kArea, 1e-9);
  EXPECT_NEAR(laid.feed(), 30.0, 1e-9);
  // Retracted, brought elsewhere and returned: of what goes beyond, half a millimetre primes.
  take(laid, "G1 E6.5 F1800\nG0 X0 Y0\nG1 E8\nM104 S200");
  EXPECT_NEAR(laid.length(), 50.0, 1e-9);
  EXPECT_NEAR(laid.volume(), 8.0 * kArea, 1e-9);
}

TEST(LaidFilament, FollowsRelativeLengthsArcsAndVolumes) {
  LaidFilament laid(2.0);
  take(laid, "M83\nG1 X10 Y0 F600\nG2 X10 Y20 I0 J10 E2");
  EXPECT_NEAR(laid.length(), 10.0 * M_PI, 0.02) << "half a circle, by its chords";
  EXPECT_NEAR(laid.volume(), 2.0 * kArea, 1e-9);
  take(laid, "M200 D1.75\nG1 X10 Y30 E4\nM200 D0\nG1 Y40 E1");
  EXPECT_NEAR(laid.volume(), 3.0 * kArea + 4.0, 1e-9);
  EXPECT_NEAR(laid.length(), 10.0 * M_PI + 20.0, 0.02);
}

TEST(LaidFilament, PassesOverWhatItCannotReadAndThatLaysNothing) {
  for (const std::string command :
       {"G28 W", "G90.1", "G92.1", "G21 G90 G94", "G1 X5 F0", "G0 A90", "G1 C10 F600", "G5 X5 I1 J1 P1 Q1"}) {
    LaidFilament laid(2.0);
    take(laid, "M83\nG92 E0\nG1 E5 F300\n" + command + "\nM83\nG1 X0 Y10 F1200\nG1 X40 Y40 E2.5");
    EXPECT_NEAR(laid.length(), 50.0, 1e-9) << command;
    EXPECT_NEAR(laid.volume(), 7.5 * kArea, 1e-9) << command;
    EXPECT_NEAR(laid.feed(), 20.0, 1e-9) << command;
    EXPECT_EQ(laid.fault(), "") << command;
  }
}

TEST(LaidFilament, KnowsNothingFromACommandOnThatLaysWhatItCannotRead) {
  LaidFilament laid(2.0);
  take(laid, "G1 X10 E1 F600\nG5 X20 I1 J1 P1 Q1 E2\nG1 X30 E9");
  EXPECT_TRUE(std::isnan(laid.length()));
  EXPECT_TRUE(std::isnan(laid.volume()));
  EXPECT_TRUE(std::isnan(laid.feed()));
  EXPECT_EQ(laid.fault().find("G5 X20 I1 J1 P1 Q1 E2: "), 0U) << laid.fault();
}

TEST(LaidFilament, CountsVolumesAsMarlinIsSet) {
  LaidFilament laid(2.0);
  take(laid, "M83\nG1 X10 E1 F600\nM2000 D1.75\nG1 X20 E1");
  EXPECT_NEAR(laid.volume(), 2.0 * kArea, 1e-9) << "another command";
  take(laid, "M200 D1.75\nG1 X30 E4\nM200 S0\nG1 X40 E1\nM200 S1\nG1 X50 E4\nM200 D1.75 S0\nG1 X60 E1");
  EXPECT_NEAR(laid.volume(), 4.0 * kArea + 8.0, 1e-9);
}

TEST(LaidFilament, FindsTheDiameterAtEitherEndOfAProgram) {
  const std::string lines(200000, '\n');
  std::istringstream begins("; program.filament_diameter_mm = 2.85\n" + lines + "G1 X1\n");
  EXPECT_EQ(filamentDiameterOf(begins), 2.85);
  std::istringstream ends("G1 X1\n" + lines + "; filament_diameter = 1.75\n");
  EXPECT_EQ(filamentDiameterOf(ends), 1.75);
  std::istringstream amid(lines + "; filament_diameter = 1.75\n" + lines);
  EXPECT_FALSE(filamentDiameterOf(amid));
  std::istringstream nothing("");
  EXPECT_FALSE(filamentDiameterOf(nothing));
}

}  // namespace
}  // namespace lamina
