// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A print whose feeder clogs, planned anew while it is under way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>

#include "lamina/control/replanned_toolpath.hpp"
#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

using test::SensedWall;
using test::sensedWall;
using test::SensedWallCase;

constexpr std::size_t kClogLayer = 20;

/// A tenth too little, and from the twentieth layer on three tenths less.
SensedWallCase cloggedPrint(Replanning replan) {
  SensedWallCase wall;
  wall.settings = test::calibratedLoop();
  wall.settings.loop.replan = replan;
  wall.layers = 40;
  wall.length_mm = 40.0;
  wall.follows_plans = true;
  wall.grows = [](std::size_t layer, double) { return layer + 1 >= kClogLayer ? 0.7 : 1.0; };
  return wall;
}

double topOf(const SensedWall& printed) {
  const std::vector<double>& heights = printed.heights_mm.back();
  return std::accumulate(heights.begin(), heights.end(), 0.0) / static_cast<double>(heights.size());
}

/// Layers laid since the clog when 6113 is told; none if it is not.
std::size_t layersUntilTold(const SensedWall& printed) {
  for (std::size_t k = kClogLayer - 1; k < printed.layers.size(); ++k)
    for (const RaisedAlarm& alarm : printed.layers[k].alarms)
      if (alarm.alarm == LoopAlarm::Saturated) return k + 2 - kClogLayer;
  return printed.layers.size();
}

TEST(ReplannedRun, EndsAtThePlannedTopAfterAClog) {
  // Whole layers come within half a layer of the top by themselves, and what the loop leaves is added.
  const std::pair<Replanning, double> cases[] = {{Replanning::Scale, 0.5}, {Replanning::Add, 0.75}};
  for (const auto& [replan, layers] : cases) {
    const SensedWallCase wall = cloggedPrint(replan);
    const SensedWall printed = sensedWall(wall);
    ASSERT_FALSE(printed.plans.empty());
    EXPECT_LE(layersUntilTold(printed), 4U);
    EXPECT_NEAR(topOf(printed), 60.0, layers * wall.layer_mm) << printed.plans.size() << " plans";
    RecordProperty(replan == Replanning::Scale ? "scale_mm" : "add_mm",
                   std::to_string(topOf(printed) - 60.0));
    EXPECT_EQ(printed.status.state, LoopState::Active);
    for (std::size_t k = 0; k < kClogLayer - 1; ++k)
      for (const RaisedAlarm& alarm : printed.layers[k].alarms)
        EXPECT_EQ(alarm.alarm, LoopAlarm::Inconsistent) << k << ": " << alarm.reason;
    for (const PrintPlan& plan : printed.plans)
      for (const ToolpathLayer& layer : plan.part.toolpath.layers) {
        EXPECT_GE(layer.height_mm, 0.7 * wall.layer_mm);
        EXPECT_LE(layer.height_mm, 1.3 * wall.layer_mm);
      }
  }
}

TEST(ReplannedRun, EndsTooLowWhereItIsNot) {
  for (const Replanning replan : {Replanning::Off, Replanning::Hold}) {
    const SensedWall printed = sensedWall(cloggedPrint(replan));
    EXPECT_TRUE(printed.plans.empty());
    EXPECT_LT(topOf(printed), 60.0 - 0.5 * 1.5) << "amounts alone will not do";
  }
}

TEST(ReplannedRun, GoesOnWithWhatItHasLearnt) {
  const SensedWallCase wall = cloggedPrint(Replanning::Scale);
  const SensedWall printed = sensedWall(wall);
  const PrintPlan& plan = printed.plans.front();
  EXPECT_NE(plan.part.toolpath_id.find("-of-" + printed.part.toolpath_id), std::string::npos);
  const auto first = std::find_if(printed.maps.begin(), printed.maps.end(), [&](const CorrectionMap& map) {
    return map.toolpath_id == plan.part.toolpath_id;
  });
  ASSERT_NE(first, printed.maps.end());
  EXPECT_EQ(first->layer, 0U);
  EXPECT_FALSE(first->paths.empty()) << "no layers are only learnt from again";
  EXPECT_GT(plan.flow, 1.1);
}

TEST(ReplannedRun, FollowsNoPlanButItsLatest) {
  const SensedWall printed = sensedWall(cloggedPrint(Replanning::Scale));
  LoopRun run(printed.part, cloggedPrint(Replanning::Scale).settings);
  EXPECT_FALSE(run.follow(printed.plans.front().part.toolpath_id)) << "offered by another run";
  EXPECT_EQ(run.part().toolpath_id, printed.part.toolpath_id);
}

/// A print as its poses and clouds come.
void replay(const SensedWall& printed, LoopRun& run, const std::function<bool()>& is_over) {
  std::size_t cloud = 0;
  for (const StampedTip& pose : printed.tips) {
    for (; cloud < printed.clouds.size() && printed.clouds[cloud].stamp_ns <= pose.stamp_ns; ++cloud)
      run.see(printed.clouds[cloud]);
    run.observe(pose);
    if (is_over()) return;
  }
}

/// The layer that the plan was to begin with is laid by its map after all, which may not have been passed on.
TEST(ReplannedRun, GoesOnAsBeforeWhereAPlanIsRefused) {
  const SensedWallCase wall = cloggedPrint(Replanning::Scale);
  const SensedWall printed = sensedWall(wall);
  LoopRun run(printed.part, wall.settings);
  LoopNews news;
  replay(printed, run, [&] { return !(news = run.takeNews()).plans.empty(); });
  ASSERT_EQ(news.plans.size(), 1U);
  const PrintPlan plan = news.plans.front();
  EXPECT_EQ(firstLayerOf(plan.part.toolpath_id), plan.layer);
  ASSERT_FALSE(news.maps.empty());
  EXPECT_FALSE(run.refusePlan("another", "it is out of reach"));
  EXPECT_TRUE(run.takeNews().alarms.empty());
  EXPECT_TRUE(run.refusePlan(plan.part.toolpath_id, "it is out of reach"));
  const LoopNews after = run.takeNews();
  ASSERT_EQ(after.alarms.size(), 1U);
  EXPECT_EQ(after.alarms[0].alarm, LoopAlarm::Saturated);
  EXPECT_EQ(after.alarms[0].reaction, LoopReaction::Warn);
  EXPECT_NE(after.alarms[0].reason.find("out of reach"), std::string::npos) << after.alarms[0].reason;
  ASSERT_EQ(after.maps.size(), 1U);
  EXPECT_EQ(after.maps[0].layer, plan.layer);
  EXPECT_EQ(digestOf(after.maps[0]), digestOf(news.maps.back()));
  EXPECT_FALSE(run.refusePlan(plan.part.toolpath_id, "it is out of reach")) << "once";
  EXPECT_FALSE(run.follow(plan.part.toolpath_id));
}

/// A layer that is not plane cannot be planned anew: the operator is asked.
TEST(ReplannedRun, HoldsWhereItCannotPlan) {
  SensedWallCase wall = cloggedPrint(Replanning::Scale);
  const SensedWall printed = sensedWall(wall);
  PlacedPart part = printed.part;
  part.toolpath.layers.back().paths[0].points[1].z() += 0.1;
  part.toolpath.layers.back().paths[1].points[0].z() += 0.1;
  LoopRun run(part, wall.settings);
  bool is_held = false;
  replay(printed, run, [&] { return run.place().layer > kClogLayer + 3; });
  for (const RaisedAlarm& alarm : run.takeNews().alarms)
    is_held |= alarm.alarm == LoopAlarm::Saturated && alarm.reaction == LoopReaction::Hold &&
               alarm.reason.find("plane") != std::string::npos;
  EXPECT_TRUE(is_held);
}

}  // namespace
}  // namespace lamina
