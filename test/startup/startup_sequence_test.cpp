// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/startup_sequence.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lamina/base/error.hpp"
#include "startup/large_gantry.hpp"

namespace lamina {
namespace {

using Step = StartupStep;

StartupSettings withSequence(const std::string& sequence) {
  StartupSettings settings;
  settings.sequence = sequence;
  return settings;
}

/// What is said of settings that are refused; empty if they are not.
std::string refusalOf(const StartupSettings& settings) {
  try {
    makeStartupSequence(settings);
    return {};
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

void expectRefused(const StartupSettings& settings, const std::string& part) {
  const std::string refusal = refusalOf(settings);
  EXPECT_NE(refusal.find(part), std::string::npos) << "said: '" << refusal << "'";
}

std::vector<Step> stepsOf(const std::vector<SequencedStep>& sequence) {
  std::vector<Step> steps;
  for (const SequencedStep& each : sequence) steps.push_back(each.step);
  return steps;
}

bool waitsFor(const SequencedStep& step, Step before) {
  return std::any_of(step.after.begin(), step.after.end(),
                     [&](const Prerequisite& each) { return each.step == before; });
}

TEST(StartupSequence, IsEmptyByDefault) { EXPECT_TRUE(makeStartupSequence({}).empty()); }

TEST(StartupSequence, OfTheLargeGantryIsTheOperatorsProcedure) {
  // [Garcia2024, section 3.5]: dryer, power, bed, X, Y, Z, sheet, vacuum, Z again, height map,
  // transfer.
  const auto sequence = makeStartupSequence(test::largeGantry());
  EXPECT_EQ(stepsOf(sequence),
            (std::vector<Step>{Step::DryPellets, Step::PowerOn, Step::HeatBed, Step::HomeX, Step::HomeY,
                               Step::HomeZ, Step::PlaceSheet, Step::DrawVacuum, Step::HomeZAgain,
                               Step::MapHeights, Step::TransferProgram}));
  EXPECT_TRUE(waitsFor(sequence[3], Step::HeatBed));
  EXPECT_TRUE(waitsFor(sequence[4], Step::HomeX));
  EXPECT_TRUE(waitsFor(sequence[5], Step::HomeY));
  EXPECT_FALSE(waitsFor(sequence[0], Step::PowerOn));
  EXPECT_TRUE(waitsFor(sequence[9], Step::HeatBed));
  EXPECT_TRUE(waitsFor(sequence[9], Step::DrawVacuum));
}

TEST(StartupSequence, OfTheLargeGantryHasTheNumbersOfTheProcedure) {
  const StartupSettings settings = test::largeGantry();
  EXPECT_DOUBLE_EQ(settings.dry_target_c, 80.0);
  EXPECT_DOUBLE_EQ(settings.dry_h, 4.0);
  EXPECT_DOUBLE_EQ(settings.bed_target_c, 90.0);
  EXPECT_DOUBLE_EQ(settings.bed_rate_c_min, 3.0);
  EXPECT_EQ(vacuumZones(settings), (std::vector<int>{1, 2, 3, 4}));
}

TEST(StartupSequence, HomesAxesInAnyOrderThatIsGiven) {
  const auto sequence = makeStartupSequence(withSequence("home_z home_x home_y"));
  EXPECT_TRUE(sequence[0].after.empty());
  EXPECT_TRUE(waitsFor(sequence[1], Step::HomeZ));
  EXPECT_TRUE(waitsFor(sequence[2], Step::HomeX));
}

TEST(StartupSequence, IsRefusedIfItHomesAfterTheSheetIsFixed) {
  expectRefused(
      withSequence("place_sheet draw_vacuum home_z"),
      "startup.sequence has home_z after place_sheet; expected it before: Z cannot be moved out of the way");
}

TEST(StartupSequence, IsRefusedIfAStepStandsTwice) {
  expectRefused(withSequence("home_x home_y home_x"), "startup.sequence has home_x twice");
}

TEST(StartupSequence, IsRefusedIfANameIsUnknown) {
  expectRefused(withSequence("home_x dry"), "startup.sequence has 'dry', which is no step");
  StartupSettings settings = withSequence("home_x");
  settings.skip = "home_w";
  expectRefused(settings, "startup.skip has 'home_w'");
}

TEST(StartupSequence, IsRefusedIfStepsWaitForEachOther) {
  StartupSettings settings = withSequence("heat_bed map_heights");
  settings.after[static_cast<std::size_t>(Step::HeatBed)] = "map_heights";
  expectRefused(settings, "startup.after_heat_bed has map_heights, which is not before heat_bed");
  settings.after[static_cast<std::size_t>(Step::HeatBed)] = "heat_bed";
  expectRefused(settings, "startup.after_heat_bed has heat_bed, which is not before heat_bed");
}

TEST(StartupSequence, IsRefusedIfAStepWaitsForOneThatIsMissing) {
  StartupSettings settings = withSequence("heat_bed home_x");
  settings.after[static_cast<std::size_t>(Step::HomeX)] = "dry_pellets";
  expectRefused(settings, "dry_pellets, which is not in startup.sequence");
  expectRefused(withSequence("home_z_again"), "home_z_again without home_z");
  settings = withSequence("heat_bed");
  settings.after[static_cast<std::size_t>(Step::HomeX)] = "heat_bed";
  expectRefused(settings, "startup.after_home_x is given");
  settings = withSequence("heat_bed");
  settings.skip = "home_x";
  expectRefused(settings, "startup.skip has home_x");
}

TEST(StartupSequence, IsRefusedIfTheBedCouldNotHeatAsItIsAskedTo) {
  StartupSettings settings = withSequence("heat_bed");
  settings.bed_rate_c_min = 0.0;
  expectRefused(settings, "startup.bed_rate_c_min is '0'");
  settings.bed_rate_c_min = 5.0;
  settings.bed_max_rate_c_min = 4.0;
  expectRefused(settings, "must be at most startup.bed_max_rate_c_min");
  settings.bed_rate_c_min = 3.0;
  settings.bed_target_c = 151.0;  // above the bed's maximum
  expectRefused(settings, "startup.bed_target_c is '151'");
}

TEST(StartupSequence, IsRefusedIfTheMachineIsAskedNothing) {
  StartupSettings settings = withSequence("home_x");
  settings.check_code.clear();
  expectRefused(settings, "startup.check_code is empty");
  settings.sequence.clear();
  EXPECT_EQ(refusalOf(settings), "");
}

TEST(StartupSequence, IsRefusedIfTheVacuumCannotBeChecked) {
  StartupSettings settings = withSequence("draw_vacuum");
  settings.vacuum_on_code = "M42 P{zone} S255";
  expectRefused(settings, "startup.vacuum_label is empty");
  settings.vacuum_label = "zone:";
  expectRefused(settings, "expected {zone} in it");
  settings.vacuum_label = "zone {zone}:";
  EXPECT_EQ(refusalOf(settings), "");
  settings.vacuum_zones = "";
  expectRefused(settings, "startup.vacuum_zones is empty");
  settings.vacuum_zones = "1 two";
  expectRefused(settings, "startup.vacuum_zones has 'two'");
  settings.vacuum_zones = "1 1";
  expectRefused(settings, "zone 1 twice");
}

}  // namespace
}  // namespace lamina
