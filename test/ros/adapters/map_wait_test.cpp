// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/trajectory_driver/map_wait.hpp"

#include <gtest/gtest.h>
#include <boost/make_shared.hpp>

#include "support/joint_paths.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using test::TiltingGantry;

constexpr double kWait = 2.0;      // s
constexpr double kLook = 0.02;     // s
constexpr double kSettling = 0.2;  // s after which a motion counts as at rest
constexpr std::size_t kLayers = 4;

/// Beads of 30 mm one upon the other, with a travel back after each.
Toolpath waitingWall() {
  Toolpath wall{"wall", {}};
  for (std::size_t k = 0; k < kLayers; ++k) {
    const double z = 0.2 * static_cast<double>(k + 1);
    Path back = test::straightPath({30, 0, z}, {0, 0, z + 0.2});
    back.role = PathRole::Travel;
    back.bead = Bead{};
    wall.layers.push_back({z, 0.2, {test::straightPath({0, 0, z}, {30, 0, z}), back}});
  }
  return wall;
}

lamina_msgs::ToolpathConstPtr planOf(const std::string& id) {
  const auto plan = boost::make_shared<lamina_msgs::Toolpath>();
  plan->id = id;
  return plan;
}

class MapWaits : public testing::Test {
 protected:
  void SetUp() override {
    hearMap(0);
    correction.takeLayers();
  }
  /// Looks, and hands over what is due, for a time.
  void drive(double time_s) {
    for (const double end_s = now_s + time_s; now_s < end_s; now_s += kLook) {
      const bool rests = now_s >= feeder.restTime() + kSettling;
      if (wait.look(now_s, rests ? MapWait::Motion::Rests : MapWait::Motion::Moves)) ++entered;
      handOver();
    }
  }
  void handOver() {
    while (auto chunk = feeder.next(now_s)) correction.corrected(*std::move(chunk));
  }
  void driveToRest() {
    drive(3.0 * kLook);  // to be held
    drive(feeder.restTime() - now_s + 2.0 * kSettling);
    EXPECT_TRUE(feeder.isHeld());
  }
  /// Its map is there in time for the layer that comes next.
  void hearMap(std::size_t layer) { EXPECT_EQ(correction.hear({"wall", layer, 1, {}}, "digest"), ""); }
  std::size_t layerAtRest() const { return feeder.at(1e6).heading_for.layer; }

  TiltingGantry gantry;
  Toolpath wall = waitingWall();
  TimedPath timed{wall, uprightPath(wall, gantry), gantry, TimingSettings()};
  TrajectoryFeeder feeder{timed, {}};
  ChunkCorrection correction{{"wall", wall}, LoopSettings(), gantry};
  MapWait wait{feeder, correction, kWait};
  double now_s = 0.0;
  int entered = 0;
};

TEST_F(MapWaits, RestInFrontOfALayerUntilItsMapHasCome) {
  driveToRest();
  EXPECT_EQ(layerAtRest(), 0U);
  hearMap(1);
  drive(0.1);
  EXPECT_EQ(entered, 1);
  driveToRest();
  EXPECT_EQ(layerAtRest(), 1U) << "the next one is waited for, too";
  EXPECT_EQ(wait.takeNotice(), "");
}

TEST_F(MapWaits, TellAtOnceThatAMapHasNotCome) {
  driveToRest();
  correction.takeLayers();
  drive(kWait - 0.5);
  EXPECT_EQ(entered, 0);
  drive(0.6);
  EXPECT_EQ(entered, 1);
  EXPECT_NE(wait.takeNotice().find("the map of layer 1 has not come within 2 s"), std::string::npos);
  const std::vector<DrivenLayer> reported = correction.takeLayers();
  ASSERT_EQ(reported.size(), 1U);
  EXPECT_EQ(reported[0].toolpath_id, "wall");
  EXPECT_EQ(reported[0].digest, "");
  EXPECT_EQ(reported[0].missed.layer, 1U);
  EXPECT_NEAR(reported[0].missed.waited_s, kWait, 2.0 * kLook);
}

/// What was reported of a layer is reported anew once its map comes after all.
TEST_F(MapWaits, UseAMapThatComesAfterItWasGivenUp) {
  driveToRest();
  drive(kWait + 1.0);
  EXPECT_EQ(entered, 1);
  correction.takeLayers();
  hearMap(1);
  const std::vector<DrivenLayer> reported = correction.takeLayers();
  ASSERT_EQ(reported.size(), 1U);
  EXPECT_EQ(reported[0].digest, "digest");
  ASSERT_TRUE(reported[0].missed.held_from) << "its beginning is handed over";
  EXPECT_GT(reported[0].missed.held_from->along_mm, 0.0);
}

/// A plan that comes once its first layer was given up would lay the layers above one too high.
TEST_F(MapWaits, RefusePlansOfALayerThatWasEntered) {
  driveToRest();
  drive(kWait + 0.2);
  ASSERT_EQ(entered, 1);
  ASSERT_TRUE(feeder.isHeld()) << "in front of the next one";
  correction.takeLayers();
  const std::string refusal = wait.offer(planOf("plan-from-1-of-wall"));
  EXPECT_NE(refusal.find("begins with layer 1; the machine is held in front of layer 2"), std::string::npos)
      << refusal;
  EXPECT_EQ(wait.plan(), nullptr);
  const std::vector<DrivenLayer> reported = correction.takeLayers();
  ASSERT_EQ(reported.size(), 1U);
  EXPECT_EQ(reported[0].toolpath_id, "plan-from-1-of-wall");
  EXPECT_EQ(reported[0].digest, "");
  EXPECT_NE(reported[0].missed.reason.find(refusal), std::string::npos) << reported[0].missed.reason;
  EXPECT_EQ(wait.offer(planOf("plan-from-2-of-wall")), "");
}

/// Paused on the way to rest, and gone on with by the map of that layer.
TEST_F(MapWaits, ForgetAPlanOfALayerThatIsEnteredWithoutIt) {
  drive(3.0 * kLook);
  ASSERT_TRUE(feeder.isHeld());
  EXPECT_EQ(wait.offer(planOf("plan-from-1-of-wall")), "");
  feeder.pause(now_s);
  drive(feeder.restTime() - now_s + 2.0 * kSettling);
  hearMap(1);
  wait.resume(now_s);
  ASSERT_TRUE(feeder.isHeld()) << "in front of the second layer";
  EXPECT_EQ(wait.plan(), nullptr);
}

TEST_F(MapWaits, RefusePlansOfOtherToolpathsAndOfNoLayer) {
  driveToRest();
  correction.takeLayers();
  EXPECT_NE(wait.offer(planOf("plan-from-1-of-other")).find("no plan of toolpath wall"), std::string::npos);
  EXPECT_TRUE(correction.takeLayers().empty()) << "it concerns nobody who follows this print";
  EXPECT_NE(wait.offer(planOf("plan-of-wall")).find("does not say which layer"), std::string::npos);
  EXPECT_EQ(correction.takeLayers().size(), 1U);
  EXPECT_EQ(wait.plan(), nullptr);
}

TEST_F(MapWaits, RefusePlansWhereTheMotionIsNotHeld) {
  for (std::size_t layer = 1; layer < kLayers; ++layer) hearMap(layer);
  drive(0.1);
  EXPECT_NE(wait.offer(planOf("plan-from-1-of-wall")).find("held in front of none"), std::string::npos);
}

TEST_F(MapWaits, DoNotEnterALayerThatAPlanIsThereFor) {
  driveToRest();
  EXPECT_EQ(wait.offer(planOf("plan-from-1-of-wall")), "");
  ASSERT_NE(wait.plan(), nullptr);
  hearMap(1);
  drive(2.0 * kWait);
  EXPECT_EQ(entered, 0);
  EXPECT_EQ(wait.plan()->id, "plan-from-1-of-wall");
}

/// Not with the next layer either, nor after a pause: it was for the layer that comes now.
TEST_F(MapWaits, ForgetAPlanThatCannotBeDriven) {
  driveToRest();
  EXPECT_EQ(wait.offer(planOf("plan-from-1-of-wall")), "");
  drive(kWait);
  correction.takeLayers();
  wait.refuse("plan-from-1-of-wall", "a waypoint is out of reach");
  EXPECT_EQ(wait.plan(), nullptr);
  const std::vector<DrivenLayer> reported = correction.takeLayers();
  ASSERT_EQ(reported.size(), 1U);
  EXPECT_EQ(reported[0].toolpath_id, "plan-from-1-of-wall");
  feeder.pause(now_s);
  now_s += 5.0;
  wait.resume(now_s);
  EXPECT_EQ(wait.plan(), nullptr);
  drive(kWait - 0.5);
  EXPECT_EQ(entered, 0) << "its map is waited for anew";
  hearMap(1);
  driveToRest();
  EXPECT_EQ(entered, 1);
  EXPECT_EQ(wait.plan(), nullptr);
}

TEST_F(MapWaits, AreGoneOnWithAfterAPause) {
  driveToRest();
  drive(kWait - 0.5);
  feeder.pause(now_s);
  EXPECT_EQ(wait.offer(planOf("plan-from-1-of-wall")), "") << "it still rests in front of the layer";
  wait.refuse("plan-from-1-of-wall", "out of reach");
  now_s += 10.0;
  wait.resume(now_s);
  ASSERT_TRUE(feeder.isHeld());
  drive(kWait - 0.5);
  EXPECT_EQ(entered, 0);
  drive(1.0);
  EXPECT_EQ(entered, 1) << "no longer than ever";
}

TEST_F(MapWaits, HoldInFrontOfTheLayerAfterAPauseOnTheWay) {
  drive(0.5);
  feeder.pause(now_s);
  handOver();
  now_s = feeder.restTime() + 1.0;
  wait.resume(now_s);
  ASSERT_TRUE(feeder.isHeld());
  driveToRest();
  EXPECT_EQ(layerAtRest(), 0U);
  EXPECT_EQ(entered, 0);
}

TEST_F(MapWaits, TellOfTheLastLayerAtTheEnd) {
  hearMap(1);
  hearMap(2);
  driveToRest();
  EXPECT_EQ(layerAtRest(), 2U);
  feeder.release(now_s);
  now_s = feeder.restTime();
  handOver();
  correction.takeLayers();
  correction.end();
  const std::vector<DrivenLayer> reported = correction.takeLayers();
  ASSERT_EQ(reported.size(), 1U);
  EXPECT_EQ(reported[0].missed.layer, kLayers - 1);
}

/// Beads that go on from layer to layer: it is said once that none of the maps is waited for.
TEST(MapWait, DoesNotStopOnABead) {
  Toolpath endless{"endless", {}};
  for (std::size_t k = 0; k < 3; ++k) {
    const double from = 30.0 * static_cast<double>(k);
    endless.layers.push_back({0.2, 0.2, {test::straightPath({from, 0, 0.2}, {from + 30.0, 0, 0.2})}});
  }
  const TiltingGantry gantry;
  const TimedPath timed(endless, uprightPath(endless, gantry), gantry, TimingSettings());
  TrajectoryFeeder feeder(timed, {});
  ChunkCorrection correction({"endless", endless}, LoopSettings(), gantry);
  MapWait wait(feeder, correction, kWait);
  EXPECT_FALSE(wait.look(0.0, MapWait::Motion::Moves));
  EXPECT_FALSE(feeder.isHeld());
  EXPECT_NE(wait.takeNotice().find("cannot stop in front of layer 1"), std::string::npos);
  EXPECT_FALSE(wait.look(0.1, MapWait::Motion::Moves));
  EXPECT_EQ(wait.takeNotice(), "") << "once";
  EXPECT_EQ(feeder.restTime(), timed.duration());
}

}  // namespace
}  // namespace lamina
