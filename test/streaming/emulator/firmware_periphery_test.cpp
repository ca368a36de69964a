// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What the emulated firmware does besides printing: homing flags, dryer, vacuum, height map.
#include <gtest/gtest.h>

#include <cmath>

#include "streaming/emulator/asked_firmware.hpp"

namespace lamina {
namespace {

class FirmwarePeriphery : public test::AskedFirmware {};

TEST_F(FirmwarePeriphery, LosesHomingWithM84) {
  make({});
  EXPECT_EQ(ask("M119\n"), "Reporting endstop status\nhomed: -\nok\n");
  ask("G28 X\nG28 Z\n");
  EXPECT_EQ(ask("M119\n"), "Reporting endstop status\nhomed: XZ\nok\n");
  ask("M84 E\n");
  EXPECT_EQ(ask("M119\n"), "Reporting endstop status\nhomed: XZ\nok\n");
  ask("M84 X\n");
  EXPECT_EQ(ask("M119\n"), "Reporting endstop status\nhomed: Z\nok\n");
  ask("G28\nM18\n");
  EXPECT_EQ(ask("M119\n"), "Reporting endstop status\nhomed: -\nok\n");
}

TEST_F(FirmwarePeriphery, DoesNotMoveAnAxisThatWasNotHomedIfItIsSoConfigured) {
  EmulatedSettings settings;
  settings.speed_up = 0.0;
  settings.moves_unhomed = false;
  make(settings);
  EXPECT_EQ(ask("G1 X10 Z5 F6000\n"), "echo:Home XZ First\nok\n");
  EXPECT_EQ(ask("G29\n"), "echo:Home XYZ First\nok\n");
  ask("G28 X\n");
  EXPECT_EQ(ask("G1 X10\nM400\n"), "ok\nok\n");
  EXPECT_NEAR(firmware_->position().x(), 10.0, 1e-9);
  EXPECT_EQ(ask("M84\nG1 X20\n"), "ok\necho:Home X First\nok\n");
  EXPECT_NEAR(firmware_->position().x(), 10.0, 1e-9);
}

TEST_F(FirmwarePeriphery, HeatsItsDryerAtItsRate) {
  EmulatedSettings settings;
  EXPECT_EQ((make(settings), ask("M141 S80\n")), "echo:Unknown command: \"M141 S80\"\nok\n");
  settings.has_dryer = true;
  settings.dryer_heating_c_s = 0.5;
  make(settings);
  ask("M141 S80\n");
  wait(10.0);
  EXPECT_EQ(ask("M105\n", 10.0), "ok T:25.00 /0.00 B:25.00 /0.00 C:30.00 /80.00 @:0 B@:0 C@:0\n");
  wait(110.0);
  EXPECT_EQ(ask("M105\n", 110.0), "ok T:25.00 /0.00 B:25.00 /0.00 C:80.00 /80.00 @:0 B@:0 C@:0\n");
}

TEST_F(FirmwarePeriphery, HeatsItsBedNoHotterThanItCan) {
  EmulatedSettings settings;
  settings.bed_limit_c = 60.0;
  make(settings);
  ask("M140 S90\n");
  wait(100.0);
  EXPECT_EQ(ask("M105\n", 100.0), "ok T:25.00 /0.00 B:60.00 /90.00 @:0 B@:0\n");
}

TEST_F(FirmwarePeriphery, DrawsTheVacuumOfZonesOneOfWhichLeaks) {
  EmulatedSettings settings;
  settings.vacuum_zones = 2;
  settings.vacuum_time_s = 5.0;
  settings.vacuum_kpa = 10.0;
  settings.leaking_zone = 2;
  settings.leak_kpa = 70.0;
  make(settings);
  EXPECT_EQ(ask("M43 P1\n"), "zone 1: 101.3 kPa\nok\n");
  ask("M42 P1 S255\nM42 P2 S255\n");
  wait(5.0);
  EXPECT_EQ(ask("M43 P1\n", 5.0), "zone 1: 43.6 kPa\nok\n");  // 10 + 91.325 / e
  wait(100.0);
  EXPECT_EQ(ask("M43 P1\nM43 P2\n", 100.0), "zone 1: 10.0 kPa\nok\nzone 2: 70.0 kPa\nok\n");
  ask("M42 P1 S0\n", 100.0);
  wait(200.0);
  EXPECT_EQ(ask("M43 P1\n", 200.0), "zone 1: 101.3 kPa\nok\n");
  EXPECT_EQ(ask("M42 P3 S255\n", 200.0), "echo:Ignored: \"M42 P3 S255\"; expected P of a vacuum zone\nok\n");
}

TEST_F(FirmwarePeriphery, FindsTheBumpOfItsBed) {
  EmulatedSettings settings;
  settings.bump_mm = 0.5;
  make(settings);
  EXPECT_EQ(ask("G29\n"), "");
  const std::string map = wait(60.0);  // 25 points of 2 s each
  EXPECT_EQ(map.substr(map.find("Bilinear")).substr(0, 23), "Bilinear Leveling Grid:");
  EXPECT_NE(map.find("\n 2 +0.009 +0.184 +0.500 +0.184 +0.009\n"), std::string::npos)
      << map;  // 0.5 / e beside it
  EXPECT_EQ(map.substr(map.size() - 3), "ok\n");
}

TEST_F(FirmwarePeriphery, SwitchesItsBedOffAndHaltsInAnEmergency) {
  make({});
  ask("M140 S90\n");
  EXPECT_DOUBLE_EQ(firmware_->bedTarget(), 90.0);
  EXPECT_NE(ask("M112\n").find("Printer halted"), std::string::npos);
  EXPECT_DOUBLE_EQ(firmware_->bedTarget(), 0.0);
}

}  // namespace
}  // namespace lamina
