// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/standing_conditions.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

RaisedAlarm raisedAs(LoopAlarm alarm) { return {alarm, LoopReaction::Coast, "as it is"}; }

LoopStatus runningLoop() {
  LoopStatus status;
  status.state = LoopState::Active;
  return status;
}

/// "6101 6103 "
std::string idsOf(const std::vector<RaisedAlarm>& alarms) {
  std::string text;
  for (const RaisedAlarm& each : alarms) text += std::to_string(static_cast<int>(each.alarm)) + ' ';
  return text;
}

TEST(StandingConditions, AreThoseWhoseCauseLasts) {
  StandingConditions conditions;
  for (int id = 6101; id <= 6116; ++id) conditions.raise(raisedAs(static_cast<LoopAlarm>(id)));
  EXPECT_EQ(idsOf(conditions.all()), "6101 6102 6103 6105 ");
  conditions.raise({LoopAlarm::Silent, LoopReaction::Hold, "for longer"});
  EXPECT_EQ(idsOf(conditions.all()), "6102 6103 6105 6101 ");
  EXPECT_EQ(conditions.all().back().reason, "for longer");
}

TEST(StandingConditions, EndWithWhatTheWatchesFind) {
  StandingConditions conditions;
  StandingAlarms watched;
  watched.risen({raisedAs(LoopAlarm::Silent), raisedAs(LoopAlarm::Stuck), raisedAs(LoopAlarm::TimeOffset)});
  for (const LoopAlarm alarm : {LoopAlarm::Silent, LoopAlarm::Stuck, LoopAlarm::TimeOffset})
    conditions.raise(raisedAs(alarm));
  LoopStatus status = runningLoop();
  conditions.settle(status, watched);
  conditions.settleSight(status, watched);
  EXPECT_EQ(idsOf(conditions.all()), "6101 6103 6105 ") << "all are watched";
  watched.risen({});
  status.coasting_for = CoastingFor::TimeOffset;
  conditions.settle(status, watched);
  EXPECT_EQ(idsOf(conditions.all()), "6101 6105 ") << "no cloud came, nor is the sensor calibrated";
  status.coasting_for = CoastingFor::Nothing;
  conditions.settle(status, watched);
  EXPECT_EQ(idsOf(conditions.all()), "6101 ");
  status.unmeasured_layers = 3;
  conditions.settleSight(status, watched);
  EXPECT_EQ(idsOf(conditions.all()), "6101 ") << "clouds measure nothing";
  status.unmeasured_layers = 0;
  conditions.settleSight(status, watched);
  EXPECT_EQ(idsOf(conditions.all()), "");
}

TEST(StandingConditions, EndWithTheLoop) {
  StandingConditions conditions;
  StandingAlarms watched;
  watched.risen({raisedAs(LoopAlarm::Stuck)});
  conditions.raise(raisedAs(LoopAlarm::Stuck));
  conditions.settle(LoopStatus(), watched);
  EXPECT_TRUE(conditions.all().empty());
}

/// What stands while the bead of each of eight layers is deposited, the sensor failing over the fourth.
std::vector<std::string> standingOver(test::SensorDoes does, std::size_t layers) {
  test::SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.settings.loop.silence_s = 0.5;
  wall.sensor = [=](std::size_t layer) {
    return layer >= 3 && layer < 3 + layers ? does : test::SensorDoes::Measure;
  };
  std::vector<std::string> standing;
  wall.operates = [&standing](std::size_t /*layer*/, const LoopRun& run) {
    standing.push_back(idsOf(run.standing()));
  };
  sensedWall(wall);
  return standing;
}

TEST(StandingConditions, LastUntilAPrintIsSeenAgain) {
  using test::SensorDoes;
  const std::vector<std::string> silent = {"", "", "", "", "6101 ", "", "", ""};
  EXPECT_EQ(standingOver(SensorDoes::KeepSilent, 1), silent);
  const std::vector<std::string> for_long = {"", "", "", "", "6101 ", "6101 ", "6101 ", ""};
  EXPECT_EQ(standingOver(SensorDoes::KeepSilent, 3), for_long) << "not told as gone between two scans";
  const std::vector<std::string> stuck = {"", "", "", "", "6103 ", "", "", ""};
  EXPECT_EQ(standingOver(SensorDoes::SayNothing, 1), stuck);
  const std::vector<std::string> blind = {"", "", "", "", "6102 ", "", "", ""};
  EXPECT_EQ(standingOver(SensorDoes::LoseTransform, 1), blind);
}

}  // namespace
}  // namespace lamina
