// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/supervision.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace lamina {
namespace {

StabilityReport sound() { return {true, 3.0, {}, ""}; }
LoopStatus activeLoop() { return afterRequest(LoopRequest::Active, sound()); }

LayerFigures soundFigures(double mean_error_mm = 0.02, double rmse_mm = 0.05) {
  LayerFigures figures;
  figures.height_mm = 1.5;
  figures.mean_error_mm = mean_error_mm;
  figures.rmse_mm = rmse_mm;
  figures.coverage = 0.9;
  figures.is_measured = true;
  return figures;
}

LayerFigures unmeasured() {
  LayerFigures figures = soundFigures();
  figures.coverage = 0.0;
  figures.is_measured = false;
  return figures;
}

bool raised(const LoopStep& step, LoopAlarm alarm, LoopReaction reaction) {
  for (const RaisedAlarm& each : step.alarms)
    if (each.alarm == alarm && each.reaction == reaction) return true;
  return false;
}

TEST(Supervision, StartsOnlyWhatMayStart) {
  EXPECT_EQ(activeLoop().state, LoopState::Active);
  EXPECT_EQ(afterRequest(LoopRequest::Identify, sound()).state, LoopState::Identifying);
  const LoopStatus blocked = afterRequest(LoopRequest::Active, {false, 3.0, {}, "not calibrated"});
  EXPECT_EQ(blocked.state, LoopState::Blocked);
  EXPECT_EQ(blocked.reason, "not calibrated");
  EXPECT_EQ(afterRequest(LoopRequest::Off, {}).state, LoopState::Off);
}

TEST(Supervision, FindsNothingWrongWithASoundLayer) {
  const LoopStep step = afterLayer(activeLoop(), soundFigures(), {});
  EXPECT_EQ(step.status.state, LoopState::Active);
  EXPECT_TRUE(step.alarms.empty());
}

TEST(Supervision, CoastsWithoutCloudsAndComesBack) {
  SensorWatch watch;
  watch.is_scanning = true;
  watch.silent_s = 2.1;
  const LoopStep lost = afterWatch(activeLoop(), watch, {});
  EXPECT_EQ(lost.status.state, LoopState::Coasting);
  EXPECT_TRUE(raised(lost, LoopAlarm::Silent, LoopReaction::Coast));
  EXPECT_EQ(lost.alarms[0].reason, "no cloud for 2.1 s; expected one every 2 s");
  EXPECT_EQ(afterLayer(lost.status, soundFigures(), {}).status.state, LoopState::Active);
  watch.is_scanning = false;
  EXPECT_TRUE(afterWatch(activeLoop(), watch, {}).alarms.empty()) << "none is due";
}

TEST(Supervision, HoldsOrOpensAfterThreeLayersUnmeasured) {
  for (const LossOfSight on_loss : {LossOfSight::Hold, LossOfSight::Open}) {
    LoopSettings settings;
    settings.on_loss = on_loss;
    LoopStep step{activeLoop(), {}};
    for (int layer = 0; layer < 3; ++layer) {
      EXPECT_TRUE(step.alarms.empty());
      step = afterLayer(step.status, unmeasured(), settings);
      EXPECT_TRUE(layer == 2 || step.status.state == LoopState::Coasting);
    }
    const bool holds = on_loss == LossOfSight::Hold;
    EXPECT_TRUE(raised(step, LoopAlarm::Silent, holds ? LoopReaction::Hold : LoopReaction::Open));
    EXPECT_EQ(step.status.state, holds ? LoopState::Coasting : LoopState::Open);
  }
}

TEST(Supervision, NamesWhatIsWrongWithTheSensor) {
  SensorWatch watch;
  watch.is_scanning = true;
  watch.blind_s = 3.0;
  EXPECT_TRUE(raised(afterWatch(activeLoop(), watch, {}), LoopAlarm::NoTransform, LoopReaction::Coast));
  watch.blind_s = 0.0;
  watch.unplaced_s = 3.0;
  const LoopStep unplaced = afterWatch(activeLoop(), watch, {});
  EXPECT_TRUE(raised(unplaced, LoopAlarm::NoTransform, LoopReaction::Coast));
  EXPECT_EQ(unplaced.alarms[0].reason,
            "clouds, but none whose frame tf knows over the bed for 3 s; expected one every 2 s");
  watch = {};
  watch.profiles = 50;
  watch.variance_mm2 = 1e-12;
  EXPECT_TRUE(raised(afterWatch(activeLoop(), watch, {}), LoopAlarm::Stuck, LoopReaction::Coast));
  watch.variance_mm2 = std::nan("");
  EXPECT_TRUE(raised(afterWatch(activeLoop(), watch, {}), LoopAlarm::Stuck, LoopReaction::Coast));
  watch.profiles = 49;
  EXPECT_TRUE(afterWatch(activeLoop(), watch, {}).alarms.empty());
}

TEST(Supervision, CoastsUntilCalibratedWhenTheTimeOffsetMoves) {
  SensorWatch watch;
  watch.time_offset_sigmas = 3.5;
  const LoopStep step = afterWatch(activeLoop(), watch, {});
  EXPECT_TRUE(raised(step, LoopAlarm::TimeOffset, LoopReaction::Coast));
  const LoopStatus after = afterLayer(step.status, soundFigures(), {}).status;
  EXPECT_EQ(after.state, LoopState::Coasting) << "a layer that is seen does not mend it";
  EXPECT_EQ(afterRequest(LoopRequest::Active, sound()).state, LoopState::Active);
}

TEST(Supervision, LeavesAContestedLayerOut) {
  LayerFigures figures = soundFigures();
  figures.contested_share = 0.25;
  const LoopStep step = afterLayer(activeLoop(), figures, {});
  EXPECT_TRUE(raised(step, LoopAlarm::Contested, LoopReaction::LeaveOut));
  EXPECT_EQ(step.status.unmeasured_layers, 1);
  figures.is_measured = false;  // so much is contested that too little is seen
  EXPECT_TRUE(raised(afterLayer(activeLoop(), figures, {}), LoopAlarm::Contested, LoopReaction::LeaveOut));
}

/// Two thirds of the length were seen, and on three tenths the surface lies 9 mm down.
TEST(Supervision, HoldsWhenAPieceFellOutOfSight) {
  const LoopStatus before = afterLayer(activeLoop(), soundFigures(0.1), {}).status;
  LayerFigures figures = soundFigures(0.1);
  figures.coverage = 0.66;
  figures.fallen = {0.3, 9.0};
  const LoopStep step = afterLayer(before, figures, {});
  EXPECT_TRUE(raised(step, LoopAlarm::Step, LoopReaction::Hold));
  EXPECT_TRUE(raised(step, LoopAlarm::Deviation, LoopReaction::Warn));
  EXPECT_NE(step.alarms[0].reason.find("30 % of the length lies 9 mm below the plan"), std::string::npos);
  EXPECT_NEAR(step.status.mean_error_mm, (0.66 * 0.1 + 0.3 * 9.0) / 0.96, 1e-12);
  const LoopStep next = afterLayer(step.status, figures, {});
  EXPECT_FALSE(raised(next, LoopAlarm::Step, LoopReaction::Hold)) << "it was told";
  EXPECT_TRUE(raised(next, LoopAlarm::Deviation, LoopReaction::Hold));
  figures.coverage = 0.2;
  figures.is_measured = false;
  EXPECT_TRUE(raised(afterLayer(before, figures, {}), LoopAlarm::Step, LoopReaction::Hold))
      << "so much that the rest is no measurement";
}

TEST(Supervision, HoldsWhenTheMeanJumps) {
  const LoopStatus before = afterLayer(activeLoop(), soundFigures(0.1), {}).status;
  EXPECT_TRUE(raised(afterLayer(before, soundFigures(1.3), {}), LoopAlarm::Step, LoopReaction::Hold));
  EXPECT_TRUE(raised(afterLayer(before, soundFigures(-1.1), {}), LoopAlarm::Step, LoopReaction::Hold));
  EXPECT_TRUE(afterLayer(before, soundFigures(1.2), {}).alarms.empty());
  EXPECT_TRUE(afterLayer(activeLoop(), soundFigures(9.0), {}).alarms.empty()) << "nothing to compare with";
}

TEST(Supervision, AllowsEachLayerThatWasNotMeasuredItsStep) {
  LayerFigures figures = soundFigures(0.1);
  figures.layer = 4;
  LoopStatus status = afterLayer(activeLoop(), figures, {}).status;
  for (int k = 0; k < 2; ++k) status = afterLayer(status, unmeasured(), {}).status;
  figures = soundFigures(1.3);  // 1.2 mm in three layers: 0.27 of each
  figures.layer = 7;
  EXPECT_FALSE(raised(afterLayer(status, figures, {}), LoopAlarm::Step, LoopReaction::Hold));
}

TEST(Supervision, TakesANewPlanForNoStep) {
  LayerFigures figures = soundFigures(1.4, 1.4);
  figures.limited_share = 0.06;
  LoopStatus status = afterLayer(activeLoop(), figures, {}).status;
  status = afterReplan(status, -1.4);
  EXPECT_EQ(status.state, LoopState::Active);
  EXPECT_EQ(status.saturated_layers, 0);
  figures = soundFigures(0.05);
  figures.layer = 1;
  EXPECT_TRUE(afterLayer(status, figures, {}).alarms.empty());
}

TEST(Supervision, WarnsOfDeviationAndHoldsAtTheSecondLayer) {
  LayerFigures figures = soundFigures();
  figures.deviating_share = 0.03;
  const LoopStep first = afterLayer(activeLoop(), figures, {});
  EXPECT_TRUE(raised(first, LoopAlarm::Deviation, LoopReaction::Warn));
  EXPECT_TRUE(raised(afterLayer(first.status, figures, {}), LoopAlarm::Deviation, LoopReaction::Hold));
}

TEST(Supervision, HoldsBeforeALump) {
  EXPECT_TRUE(raised(beforeLayer(activeLoop(), 3.1, 3.0), LoopAlarm::Lump, LoopReaction::Hold));
  EXPECT_TRUE(beforeLayer(activeLoop(), 2.9, 3.0).alarms.empty());
}

TEST(Supervision, ReplansWhatIsAtItsLimits) {
  LayerFigures figures = soundFigures();
  figures.limited_share = 0.06;
  for (const Replanning replan : {Replanning::Hold, Replanning::Scale}) {
    LoopSettings settings;
    settings.replan = replan;
    LoopStep step{activeLoop(), {}};
    for (int layer = 0; layer < 3; ++layer) {
      EXPECT_TRUE(step.alarms.empty());
      step = afterLayer(step.status, figures, settings);
    }
    const LoopReaction reaction = replan == Replanning::Hold ? LoopReaction::Hold : LoopReaction::Replan;
    EXPECT_TRUE(raised(step, LoopAlarm::Saturated, reaction));
  }
}

TEST(Supervision, SuspectsALoopWhoseErrorGrows) {
  LoopStep step{activeLoop(), {}};
  for (const double rmse : {0.3, 0.37, 0.46, 0.57})
    step = afterLayer(step.status, soundFigures(0.0, rmse), {});
  EXPECT_TRUE(raised(step, LoopAlarm::Diverging, LoopReaction::Coast));
  EXPECT_EQ(step.status.state, LoopState::Coasting);
  EXPECT_EQ(afterLayer(step.status, soundFigures(), {}).status.state, LoopState::Coasting);
}

TEST(Supervision, WarnsOfGrowthAndOfTheFilter) {
  LayerFigures figures = soundFigures();
  figures.gain_least = 0.45;
  EXPECT_TRUE(raised(afterLayer(activeLoop(), figures, {}), LoopAlarm::Growth, LoopReaction::Warn));
  figures = soundFigures();
  figures.repeatability = 3.0;
  LoopStep step{activeLoop(), {}};
  for (int layer = 0; layer < 3; ++layer) step = afterLayer(step.status, figures, {});
  ASSERT_TRUE(raised(step, LoopAlarm::Inconsistent, LoopReaction::Warn));
  EXPECT_NE(step.alarms[0].reason.find("sensor's noise"), std::string::npos);
}

TEST(Supervision, CoastsThroughALayerWhoseMapIsLate) {
  SensorWatch watch;
  watch.map_late_s = 2.5;
  const LoopStep step = afterWatch(activeLoop(), watch, {});
  EXPECT_TRUE(raised(step, LoopAlarm::MapLate, LoopReaction::Coast));
  EXPECT_EQ(step.status.state, LoopState::Active) << "that layer alone";
}

TEST(Supervision, IsSwitchedOffFromEveryState) {
  EXPECT_TRUE(rc::check("after any events", [] {
    LoopStatus status = activeLoop();
    const int events = *rc::gen::inRange(0, 30);
    LoopSettings settings;
    settings.on_loss = *rc::gen::element(LossOfSight::Hold, LossOfSight::Open);
    for (int i = 0; i < events; ++i) {
      LayerFigures figures = *rc::gen::arbitrary<bool>() ? soundFigures() : unmeasured();
      figures.mean_error_mm = 0.1 * *rc::gen::inRange(-50, 50);
      figures.rmse_mm = 0.1 * *rc::gen::inRange(0, 50);
      figures.limited_share = 0.01 * *rc::gen::inRange(0, 20);
      SensorWatch watch;
      watch.is_scanning = *rc::gen::arbitrary<bool>();
      watch.silent_s = 0.1 * *rc::gen::inRange(0, 50);
      watch.time_offset_sigmas = 0.1 * *rc::gen::inRange(0, 40);
      status = afterWatch(afterLayer(status, figures, settings).status, watch, settings).status;
      RC_ASSERT(status.state != LoopState::Off && status.state != LoopState::Blocked);
    }
    RC_ASSERT(afterRequest(LoopRequest::Off, {}).state == LoopState::Off);
    RC_ASSERT(afterRequest(LoopRequest::Active, sound()).state == LoopState::Active);
  }));
}

TEST(Supervision, JudgesNothingWhileOff) {
  EXPECT_TRUE(afterLayer({}, unmeasured(), {}).alarms.empty());
  EXPECT_TRUE(beforeLayer({}, 9.0, 1.0).alarms.empty());
}

}  // namespace
}  // namespace lamina
