// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/process_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

ProcessSignals flowing(double flow_mm3_s) {
  ProcessSignals signals;
  signals.flow_mm3_s = flow_mm3_s;
  return signals;
}

ProcessChunk chunk(std::vector<PlannedProcess> points) {
  const double end_s = points.back().time_s;
  return {std::move(points), end_s};
}

TEST(ProcessPlan, KnowsNothingBeforeAndAfterItsChunks) {
  ProcessPlan plan;
  EXPECT_FALSE(plan.at(0.0));
  plan.accept(chunk({{1.0, flowing(2.0)}, {2.0, flowing(4.0)}}));
  EXPECT_FALSE(plan.at(0.999));
  EXPECT_EQ(plan.at(1.0)->flow_mm3_s, 2.0);
  EXPECT_EQ(plan.at(1.5)->flow_mm3_s, 3.0);
  EXPECT_EQ(plan.at(2.0)->flow_mm3_s, 4.0);
  EXPECT_FALSE(plan.at(2.0001));
}

TEST(ProcessPlan, AChunkReplacesFromItsFirstPointOn) {
  ProcessPlan plan;
  plan.accept(chunk({{1.0, flowing(2.0)}, {2.0, flowing(2.0)}, {3.0, flowing(2.0)}}));
  plan.accept(chunk({{1.5, flowing(0.0)}, {2.5, flowing(0.0)}}));
  EXPECT_EQ(plan.at(1.0)->flow_mm3_s, 2.0);
  EXPECT_EQ(plan.at(1.5)->flow_mm3_s, 0.0);
  EXPECT_EQ(plan.at(2.5)->flow_mm3_s, 0.0);
  EXPECT_FALSE(plan.at(2.6));  // until when the older chunk would have been valid
}

TEST(ProcessPlan, NothingIsKnownBetweenChunksThatDoNotMeet) {
  ProcessPlan plan;
  plan.accept({{{1.0, flowing(2.0)}, {2.0, flowing(2.0)}}, 1.5});
  plan.accept(chunk({{3.0, flowing(4.0)}, {4.0, flowing(4.0)}}));
  EXPECT_EQ(plan.at(1.4)->flow_mm3_s, 2.0);
  EXPECT_FALSE(plan.at(1.6));
  EXPECT_FALSE(plan.at(2.5));
  EXPECT_EQ(plan.at(3.5)->flow_mm3_s, 4.0);
}

TEST(ProcessPlan, ChunksMeetWhateverRoundingLeavesBetweenThem) {
  ProcessPlan plan;
  plan.accept(chunk({{1.0, flowing(2.0)}, {2.0, flowing(2.0)}}));
  plan.accept(chunk({{2.0 + 1e-6, flowing(2.0)}, {3.0, flowing(2.0)}}));
  for (const double time_s : {2.0, 2.0 + 5e-7, 2.0 + 1e-6}) EXPECT_EQ(plan.at(time_s)->flow_mm3_s, 2.0);
}

TEST(ProcessPlan, SwitchesAndLaserPowerHoldWireGoesInProportion) {
  ProcessSignals before;
  before.is_laser_on = true;
  before.levels[ProcessLevel::LaserPower] = 900.0;
  before.levels[ProcessLevel::WireSpeed] = 10.0;
  ProcessSignals after = before;
  after.is_laser_on = false;
  after.levels[ProcessLevel::LaserPower] = 0.0;
  after.levels[ProcessLevel::WireSpeed] = 20.0;
  ProcessPlan plan;
  plan.accept(chunk({{0.0, before}, {1.0, after}}));
  const ProcessSignals halfway = *plan.at(0.5);
  EXPECT_TRUE(halfway.is_laser_on);
  EXPECT_EQ(halfway.levels[ProcessLevel::LaserPower], 900.0);
  EXPECT_EQ(halfway.levels[ProcessLevel::WireSpeed], 15.0);
  EXPECT_FALSE(halfway.levels.has(ProcessLevel::Gas));
}

TEST(ProcessPlan, RefusesWholeWhatIsNoProcess) {
  ProcessPlan plan;
  plan.accept(chunk({{1.0, flowing(2.0)}, {2.0, flowing(2.0)}}));
  ProcessSignals endless;
  endless.levels[ProcessLevel::Gas] = INFINITY;
  EXPECT_THROW(plan.accept({}), InvalidInput);
  EXPECT_THROW(plan.accept({{{1.2, flowing(1.0)}}, NAN}), InvalidInput);
  EXPECT_THROW(plan.accept({{{NAN, flowing(1.0)}}, 2.0}), InvalidInput);
  EXPECT_THROW(plan.accept(chunk({{1.4, flowing(1.0)}, {1.3, flowing(1.0)}})), InvalidInput);
  EXPECT_THROW(plan.accept(chunk({{1.4, flowing(NAN)}})), InvalidInput);
  EXPECT_THROW(plan.accept(chunk({{1.4, flowing(-1.0)}})), InvalidInput);
  EXPECT_THROW(plan.accept(chunk({{1.4, endless}})), InvalidInput);
  EXPECT_EQ(plan.at(1.5)->flow_mm3_s, 2.0);
}

TEST(ProcessPlan, HoldsLastValuesForHalfASecondWhateverIsStated) {
  ProcessPlan plan;
  plan.accept({{{1.0, flowing(2.0)}, {2.0, flowing(4.0)}}, 1e9});
  EXPECT_EQ(plan.validUntil(), 2.5);
  EXPECT_EQ(plan.at(2.5)->flow_mm3_s, 4.0);
  EXPECT_FALSE(plan.at(2.501)) << "its sender may be dead";
  plan.accept({{{1.5, flowing(0.0)}}, 1e9});
  EXPECT_EQ(plan.at(2.0)->flow_mm3_s, 0.0) << "what switches off takes effect however long it is to hold";
}

TEST(ProcessPlan, KeepsNoMorePointsThanItMay) {
  ProcessPlan plan;
  ProcessChunk many;
  for (std::size_t i = 0; i < ProcessPlan::kMostPoints; ++i)
    many.points.push_back({static_cast<double>(i), flowing(1.0)});
  EXPECT_THROW(plan.accept(many), InvalidInput);
  many.points.pop_back();
  const double last_s = many.points.back().time_s;
  many.valid_until_s = last_s + 0.25;
  plan.accept(many);
  plan.forget(last_s + 0.25);
  EXPECT_EQ(plan.at(last_s + 0.25)->flow_mm3_s, 1.0);
  EXPECT_FALSE(plan.at(last_s - 1.0));
}

}  // namespace
}  // namespace lamina
