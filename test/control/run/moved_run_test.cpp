// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A sensor that is knocked off its place amid a print: a wall of one bead, 60 x 3 mm, layers of 1.5 mm, of
// which a feeder lays nine tenths.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMoved = 6;  // layer from which on the sensor is off

test::SensedWallCase knockedWall(const Point3& off_mm) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.layers = 12;
  wall.sees_bed = true;
  wall.scan_margin_mm = 10.0;
  wall.shows_off = [off_mm](std::size_t layer) { return layer >= kMoved ? off_mm : Point3(Point3::Zero()); };
  return wall;
}

std::vector<RaisedAlarm> movedAlarms(const test::SensedWall& wall) {
  std::vector<RaisedAlarm> moved;
  for (const RaisedAlarm& alarm : wall.alarms)
    if (alarm.alarm == LoopAlarm::TimeOffset) moved.push_back(alarm);
  return moved;
}

bool isHeld(const test::SensedWall& wall) {
  return std::any_of(wall.alarms.begin(), wall.alarms.end(),
                     [](const RaisedAlarm& alarm) { return alarm.reaction == LoopReaction::Hold; });
}

std::string textsOf(const test::SensedWall& wall) {
  std::string texts;
  for (const RaisedAlarm& alarm : wall.alarms)
    texts += std::to_string(int(alarm.alarm)) + " " + alarm.reason + "\n";
  return texts;
}

/// Mean of the planned less the real height of a layer, in layers.
double offPlan(const test::SensedWall& wall, std::size_t layer) {
  double sum = 0.0;
  for (const double height : wall.heights_mm[layer]) sum += height;
  return static_cast<double>(layer + 1) - sum / static_cast<double>(wall.heights_mm[layer].size()) / 1.5;
}

/// Told in the layer in which it happens, with the figure; what it shows from then on corrects nothing.
void expectFound(const test::SensedWall& wall, const std::string& figure) {
  const auto alarms = movedAlarms(wall);
  ASSERT_EQ(alarms.size(), 1U) << textsOf(wall);
  EXPECT_NE(alarms[0].reason.find(figure), std::string::npos) << alarms[0].reason;
  EXPECT_EQ(alarms[0].reaction, LoopReaction::Coast);
  EXPECT_EQ(textsOf(wall).find("6110"), std::string::npos) << textsOf(wall);  // nothing came off
  for (std::size_t k = 0; k < wall.layers.size(); ++k) {
    bool is_told = false;
    for (const RaisedAlarm& alarm : wall.layers[k].alarms) is_told |= alarm.alarm == LoopAlarm::TimeOffset;
    EXPECT_EQ(is_told, k == kMoved) << k;
    EXPECT_EQ(wall.layers[k].state == LoopState::Active, k <= kMoved) << k;
    EXPECT_EQ(wall.layers[k].figures.is_measured, k < kMoved) << k;
  }
  // Of an error of a third to eight layers nothing is taken for one of the wall.
  for (std::size_t k = kMoved; k < wall.heights_mm.size(); ++k) EXPECT_NEAR(offPlan(wall, k), 0.0, 0.1) << k;
}

TEST(MovedRun, SeesBeadsBesideTheirPlaces) {
  for (const double beside : {1.0, -3.0, 8.0}) {
    auto wall = knockedWall({0.0, beside, 0.0});
    wall.layers = kMoved + 3;
    SCOPED_TRACE(beside);
    const auto printed = test::sensedWall(wall);
    expectFound(printed, "beads");
    ASSERT_FALSE(movedAlarms(printed).empty());
    // A quarter of a millimetre.
    const std::string reason = movedAlarms(printed)[0].reason;
    const auto at = reason.find(", y ");
    ASSERT_NE(at, std::string::npos) << reason;
    EXPECT_NEAR(std::stod(reason.substr(at + 4)), beside, 0.25) << reason;
  }
}

TEST(MovedRun, SeesTheBedRiseAndFall) {
  const std::vector<std::pair<double, std::string>> moves = {
      {0.5, "0.5 mm higher"}, {-1.0, "1 mm lower"}, {3.0, "3 mm higher"}};
  for (const auto& [up, figure] : moves) {
    auto wall = knockedWall({0.0, 0.0, up});
    wall.layers = kMoved + 3;
    SCOPED_TRACE(up);
    expectFound(test::sensedWall(wall), figure);
  }
}

/// What rises above the head's clearance is taken for a lump, until it is known that the sensor has moved.
TEST(MovedRun, SeesNoLumpOnceTheSensorIsKnownToHaveMoved) {
  auto wall = knockedWall({0.0, 0.0, 8.0});
  wall.layers = kMoved + 6;
  const auto printed = test::sensedWall(wall);
  const auto isOf = [](LoopAlarm which) {
    return [which](const RaisedAlarm& alarm) { return alarm.alarm == which; };
  };
  const auto moved = std::find_if(printed.alarms.begin(), printed.alarms.end(), isOf(LoopAlarm::TimeOffset));
  ASSERT_NE(moved, printed.alarms.end()) << textsOf(printed);
  EXPECT_NE(moved->reason.find("8 mm higher"), std::string::npos) << moved->reason;
  EXPECT_EQ(std::count_if(moved, printed.alarms.end(), isOf(LoopAlarm::Lump)), 0) << textsOf(printed);
}

/// Along a straight bead only its ends show it.
TEST(MovedRun, SeesAShiftAlongABeadByItsEnds) {
  for (const double along : {1.0, -3.0, 8.0}) {
    auto wall = knockedWall({along, 0.0, 0.0});
    wall.layers = kMoved + 3;
    SCOPED_TRACE(along);
    expectFound(test::sensedWall(wall), "beads");
    wall.sees_bed = false;
    wall.scan_margin_mm = 0.0;
    EXPECT_TRUE(movedAlarms(test::sensedWall(wall)).empty());
  }
}

/// Calibrated anew it is believed again, also if what it shows stays where it is.
TEST(MovedRun, GoesOnOnceItIsCalibrated) {
  for (const Point3& off : {Point3(0.0, 0.0, 1.0), Point3(0.0, 3.0, 0.0)}) {
    auto wall = knockedWall(off);
    wall.shows_off = [off](std::size_t layer) {
      return layer == kMoved || layer == kMoved + 1 ? off : Point3(Point3::Zero());
    };
    wall.operates = [&](std::size_t layer, LoopRun& run) {
      if (layer == kMoved + 2) run.recalibrate(wall.settings.calibration, LoopRequest::Active);
    };
    const auto printed = test::sensedWall(wall);
    ASSERT_EQ(movedAlarms(printed).size(), 1U) << textsOf(printed);
    EXPECT_EQ(printed.layers[kMoved + 1].state, LoopState::Coasting);
    EXPECT_EQ(printed.status.state, LoopState::Active);
    EXPECT_TRUE(printed.layers.back().figures.is_measured);
    EXPECT_NEAR(offPlan(printed, 11), 0.0, 0.02);
    EXPECT_FALSE(isHeld(printed)) << textsOf(printed);
  }
}

TEST(MovedRun, IsQuietWhereNothingMoved) {
  auto wall = knockedWall(Point3::Zero());
  EXPECT_TRUE(movedAlarms(test::sensedWall(wall)).empty());
  // A feeder that clogs, one that lays too much, soft ends, a slope, a piece that broke off.
  const std::vector<std::function<double(std::size_t, double)>> growths = {
      [](std::size_t layer, double) { return layer >= kMoved ? 0.6 : 1.0; },
      [](std::size_t layer, double) { return layer >= kMoved ? 1.4 : 1.0; },
      [](std::size_t, double along) { return along < 6.0 || along > 54.0 ? 0.7 : 1.0; },
      [](std::size_t, double along) { return along > 50.0 ? 0.5 : 1.1; }};
  for (const auto& grows : growths) {
    wall.grows = grows;
    const auto printed = test::sensedWall(wall);
    EXPECT_TRUE(movedAlarms(printed).empty()) << textsOf(printed);
  }
  wall.grows = {};
  wall.befalls = [](std::size_t layer, std::vector<double>& heights) {
    for (std::size_t i = 45; i < heights.size() && layer == kMoved; ++i) heights[i] = 0.0;
  };
  const auto printed = test::sensedWall(wall);
  EXPECT_TRUE(movedAlarms(printed).empty()) << textsOf(printed);
  EXPECT_TRUE(isHeld(printed));
}

}  // namespace
}  // namespace lamina
