// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/trajectory_feeder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "fed_gantry.hpp"
#include "lamina/base/error.hpp"
#include "support/joint_paths.hpp"
#include "support/random_toolpath.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using test::expectSame;
using test::fastFeeder;
using test::powderSettings;
using test::TiltingGantry;
using test::timedGantry;
using test::trajectoryFeederLine;

constexpr double kStep = 1e-3;  // s
// Sums over steps of kStep miss up to a step of each motion.
constexpr double kVolumeTolerance = 0.02;

TEST(TrajectoryFeeder, ChunksJoinExactlyAndEndAtTheEnd) {
  const TimedPath timed = timedGantry(test::twoLayers(), powderSettings());
  TrajectoryFeeder feeder(timed, {});
  auto chunk = feeder.next(0.0);
  ASSERT_TRUE(chunk);
  EXPECT_EQ(chunk->points.size(), 51U);
  EXPECT_EQ(chunk->points.front().time_s, 0.0);
  JointState last = chunk->points.back();
  for (double now_s = 0.0; feeder.state() == TrajectoryFeederState::Running; now_s += 0.1)
    while ((chunk = feeder.next(now_s))) {
      expectSame(chunk->points.front(), last);
      last = chunk->points.back();
    }
  EXPECT_GE(last.time_s, timed.duration());
  EXPECT_LT(last.time_s, timed.duration() + 1.0 / 250.0);
  EXPECT_EQ(last.velocity.norm(), 0.0);
  EXPECT_EQ(last.process, safeSignals());
}

TEST(TrajectoryFeeder, KeepsTheMotionAheadWaiting) {
  const TimedPath timed = timedGantry(test::twoLayers(), powderSettings());
  TrajectoryFeederSettings settings;
  settings.points = 25;
  settings.ahead_s = 0.3;
  TrajectoryFeeder feeder(timed, settings);
  double queued_until = 0.0;
  for (double now_s = 0.0; now_s < 1.0; now_s += 0.05) {
    while (auto chunk = feeder.next(now_s)) queued_until = chunk->points.back().time_s;
    EXPECT_GE(queued_until - now_s, 0.3);
    EXPECT_LT(queued_until - now_s, 0.3 + 2 * 0.1 + 1e-9);
  }
}

TEST(TrajectoryFeeder, RefusesChunksWithoutPoints) {
  const TimedPath timed = timedGantry(test::twoLayers(), powderSettings());
  EXPECT_THROW(TrajectoryFeeder(timed, {0.0, 10, 0.5, 0.05}), InvalidConfig);
  EXPECT_THROW(TrajectoryFeeder(timed, {250.0, 0, 0.5, 0.05}), InvalidConfig);
}

double distanceToToolpath(const Toolpath& toolpath, const Point3& tip) {
  double least = 1e9;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const Point3& a = path.points[m];
        const Point3 way = path.points[path.motionEnd(m)] - a;
        const double u = std::clamp((tip - a).dot(way) / std::max(way.squaredNorm(), 1e-12), 0.0, 1.0);
        least = std::min(least, (tip - a - u * way).norm());
      }
  return least;
}

/// What a whole job did, in steps.
struct Outcome {
  double volume = 0.0;
  double farthest = 0.0;      ///< of the tip from the toolpath [mm]
  double acceleration = 0.0;  ///< greatest, of its limit
  bool is_laser_on_at_rest = false;
};

Outcome outcomeOf(const TrajectoryFeeder& feeder, const Toolpath& toolpath, const TimingSettings& settings,
                  double until_s) {
  const TiltingGantry gantry;
  Outcome outcome;
  JointState before = feeder.at(0.0);
  for (double t = kStep; t < until_s; t += kStep) {
    const JointState state = feeder.at(t);
    outcome.volume += kStep * feeder.at(t - 0.5 * kStep).process.flow_mm3_s;
    outcome.farthest = std::max(
        outcome.farthest, distanceToToolpath(toolpath, gantry.bedFromNozzle(state.position).translation()));
    for (Eigen::Index j = 0; j < 4; ++j) {
      const double limit = gantry.joints()[j].max_speed / settings.trajectory.joint_ramp_s;
      const double found = std::abs(state.velocity[j] - before.velocity[j]) / kStep;
      outcome.acceleration = std::max(outcome.acceleration, found / limit);
    }
    before = state;
  }
  return outcome;
}

bool isSafe(const TrajectoryFeeder& feeder, double from_s, double to_s) {
  for (double t = from_s; t < to_s; t += kStep)
    if (!(feeder.at(t).process == safeSignals())) return false;
  return true;
}

// 40 mm of a square, a travel, and 10 mm of a line.
TEST(TrajectoryFeeder, BeginsOnABeadAndLaysTheRestOnce) {
  for (const double from_mm : {3.0, 10.0, 27.5, 40.0, 46.0}) {
    const TimingSettings settings = powderSettings(0.01);
    const TimedPath timed = timedGantry(test::twoLayers(), settings);
    const TrajectoryFeeder feeder(timed, {}, from_mm);
    const TiltingGantry gantry;
    const Point3 corner = from_mm <= 10.0  ? Point3(from_mm, 0, 0.2)
                          : from_mm < 30.0 ? Point3(30.0 - from_mm, 10, 0.2)
                                           : Point3(from_mm - 40.0, 0, 0.4);
    // Roundings of corners pass them at a distance.
    EXPECT_LT((gantry.bedFromNozzle(feeder.at(0.0).position).translation() - corner).norm(), 0.05) << from_mm;
    EXPECT_EQ(feeder.at(0.0).velocity.norm(), 0.0);
    EXPECT_EQ(feeder.at(0.0).process.flow_mm3_s, 0.0);
    EXPECT_NEAR(feeder.laidAt(0.0).length_mm, from_mm, 1e-6);
    EXPECT_NEAR(feeder.laidAt(feeder.restTime()).length_mm, 50.0, 1e-6);
    const Outcome outcome = outcomeOf(feeder, test::twoLayers(), settings, feeder.restTime() + 0.1);
    const double area = crossSection({0.4, 0.2});
    EXPECT_NEAR(outcome.volume, (50.0 - from_mm) * area, 50.0 * area * kVolumeTolerance) << from_mm;
    EXPECT_LT(outcome.farthest, 0.05) << from_mm;
    EXPECT_LT(outcome.acceleration, 1.01) << from_mm;
    EXPECT_LT((feeder.at(feeder.restTime()).position - timed.at(timed.duration()).position).norm(), 1e-9);
  }
}

TEST(TrajectoryFeeder, StartsItsProcessOnABeadAsAtAStart) {
  TimingSettings settings = powderSettings();
  settings.process.kind = ProcessKind::Wire;
  settings.process.settling_s = 0.4;
  settings.process.wait_before_s = 0.3;
  settings.process.laser_on_lead_s = 0.2;
  settings.process.wire_on_lead_s = 0.1;
  // Amid a motion, and at the corner of a bead.
  for (const auto& [toolpath, from_mm] :
       {std::pair(trajectoryFeederLine(), 12.0), std::pair(test::twoLayers(), 10.0)}) {
    const TrajectoryFeeder feeder(timedGantry(toolpath, settings), {}, from_mm);
    const std::vector<ProcessEvent> events = feeder.events();
    ASSERT_GE(events.size(), 3U);
    EXPECT_EQ(events[0].channel, ProcessChannel::Gas);
    EXPECT_NEAR(events[0].time_s, 0.0, 1e-9);
    EXPECT_EQ(events[1].channel, ProcessChannel::Laser);
    EXPECT_NEAR(events[1].time_s, 0.7 - 0.2, 1e-9) << from_mm;
    EXPECT_EQ(events[2].channel, ProcessChannel::Wire);
    EXPECT_NEAR(events[2].time_s, 0.7 - 0.1, 1e-9) << from_mm;
    EXPECT_EQ(feeder.at(0.7).velocity.norm(), 0.0);
    EXPECT_GT(feeder.at(0.8).velocity.norm(), 0.0);
  }
}

TEST(TrajectoryFeeder, PausesAndChangesItsSpeedWhereItBegan) {
  const TimingSettings settings = powderSettings();
  const TimedPath timed = timedGantry(trajectoryFeederLine(), settings);
  TrajectoryFeeder feeder(timed, {}, 12.0);
  feeder.setSpeed(0.5, -0.2);
  feeder.pause(0.3);
  feeder.resume(2.0);
  const Outcome outcome = outcomeOf(feeder, trajectoryFeederLine(), settings, feeder.restTime() + 0.1);
  EXPECT_NEAR(outcome.volume, 18.0 * crossSection({0.4, 0.2}), 0.05);
  EXPECT_NEAR(feeder.laidAt(feeder.restTime()).volume_mm3, 30.0 * crossSection({0.4, 0.2}), 1e-6);
}

TEST(TrajectoryFeeder, RefusesToBeginWhereAllIsLaid) {
  const TimedPath timed = timedGantry(trajectoryFeederLine(), powderSettings());
  EXPECT_THROW(TrajectoryFeeder(timed, {}, 30.0), InvalidInput);
  EXPECT_NO_THROW(TrajectoryFeeder(timed, {}, 29.9));
}

TEST(TrajectoryFeeder, PausesAnywhereAndLaysEverythingOnce) {
  EXPECT_TRUE(rc::check("a job with pauses lays what it would without, on its path, within limits", [] {
    Toolpath toolpath = test::randomToolpath(*rc::gen::arbitrary<std::uint64_t>());
    toolpath.layers.resize(1);
    auto& paths = toolpath.layers[0].paths;
    paths.resize(std::min<std::size_t>(paths.size(), 2));
    const TimingSettings settings = powderSettings(*rc::gen::element(0.0, 0.01));
    const TimedPath timed = timedGantry(toolpath, settings);
    TrajectoryFeeder feeder(timed, {});
    double now_s = 0.0;
    for (int pauses = 0; pauses < 3; ++pauses) {
      now_s += timed.duration() * 0.01 * *rc::gen::inRange(0, 40);
      feeder.pause(now_s);
      const double rest_s = feeder.restTime();
      if (feeder.state() != TrajectoryFeederState::Paused) continue;
      RC_ASSERT(feeder.at(rest_s + 1e-9).velocity.norm() < 1e-9);
      now_s = rest_s + 0.001 * *rc::gen::inRange(-20, 200);
      feeder.resume(now_s);
      RC_ASSERT(feeder.state() == TrajectoryFeederState::Running);
      RC_ASSERT(isSafe(feeder, rest_s + 1e-9, now_s));
    }
    const Outcome outcome = outcomeOf(feeder, toolpath, settings, feeder.restTime());
    RC_ASSERT(std::abs(outcome.volume / totals(toolpath).deposited_mm3 - 1.0) < kVolumeTolerance);
    RC_ASSERT(outcome.farthest < 0.05 + 1e-6);
    RC_ASSERT(outcome.acceleration < 1.0 + 1e-6);
    const JointState end = feeder.at(feeder.restTime() + 1.0);
    RC_ASSERT((end.position - timed.at(1e9).position).norm() < 1e-9);
  }));
}

TEST(TrajectoryFeeder, APauseBrakesAfterTheReaction) {
  TimingSettings settings = powderSettings();
  settings.motion.acceleration_mm_s2 = 300.0;
  const TimedPath timed = timedGantry(trajectoryFeederLine(), settings);
  TrajectoryFeeder feeder(timed, {250.0, 50, 0.5, 0.1});
  feeder.pause(0.5);
  // 30 mm/s, reached after 0.1 s and 1.5 mm, until 0.6 s; braking takes the same again.
  EXPECT_NEAR(feeder.restTime(), 0.7, 1e-9);
  EXPECT_NEAR(feeder.at(0.6).velocity[0], 30.0, 1e-9);
  EXPECT_NEAR(feeder.at(0.7).position[0], 1.5 + 15.0 + 1.5, 1e-9);
  EXPECT_TRUE(feeder.at(0.69).process.is_laser_on);
  EXPECT_EQ(feeder.at(0.7).process, safeSignals());
  feeder.resume(2.0);
  EXPECT_NEAR(feeder.restTime(), 2.1 + 12.0 / 30.0 + 0.1, 1e-9);
  EXPECT_FALSE(feeder.at(2.0).process.is_powder_on);
  EXPECT_TRUE(feeder.at(2.15).process.is_powder_on);
}

TEST(TrajectoryFeeder, GoesOnAtAShareOfTheSpeed) {
  TimingSettings settings = powderSettings();
  settings.motion.acceleration_mm_s2 = 300.0;
  const TimedPath timed = timedGantry(trajectoryFeederLine(), settings);
  TrajectoryFeeder feeder(timed, {250.0, 50, 0.5, 0.1});
  feeder.setSpeed(0.5, 0.5);
  // At 16.5 mm after 0.6 s; 0.05 s and 1.125 mm to 15 mm/s, 12 mm at that, and 0.375 mm to rest.
  EXPECT_NEAR(feeder.at(0.6).velocity[0], 30.0, 1e-9);
  EXPECT_NEAR(feeder.at(0.65).velocity[0], 15.0, 1e-9);
  EXPECT_NEAR(feeder.at(0.65).position[0], 17.625, 1e-9);
  EXPECT_NEAR(feeder.restTime(), 0.65 + 12.0 / 15.0 + 0.05, 1e-9);
  EXPECT_NEAR(feeder.at(1.0).process.flow_mm3_s, 15.0 * crossSection({0.4, 0.2}), 1e-9);
  feeder.setSpeed(1.0, 1.0);
  // At 24.375 mm after 1.1 s; 1.125 mm to full speed, 3 mm at that, 1.5 mm to rest.
  EXPECT_NEAR(feeder.at(1.15).position[0], 25.5, 1e-9);
  EXPECT_NEAR(feeder.restTime(), 1.15 + 3.0 / 30.0 + 0.1, 1e-9);
}

TEST(TrajectoryFeeder, ASpeedSetWhileItIsPausedHoldsOnceItGoesOn) {
  TimingSettings settings = powderSettings();
  settings.motion.acceleration_mm_s2 = 300.0;
  const TimedPath timed = timedGantry(trajectoryFeederLine(), settings);
  TrajectoryFeeder feeder(timed, {250.0, 50, 0.5, 0.1});
  feeder.pause(0.5);
  feeder.setSpeed(0.5, 1.0);
  EXPECT_NEAR(feeder.restTime(), 0.7, 1e-9);
  feeder.resume(2.0);
  EXPECT_NEAR(feeder.restTime(), 2.1 + 0.05 + 11.25 / 15.0 + 0.05, 1e-9);
}

TEST(TrajectoryFeeder, RefusesASpeedOutOfBounds) {
  const TimedPath timed = timedGantry(trajectoryFeederLine(), powderSettings());
  TrajectoryFeeder feeder(timed, {});
  for (const double share : {0.0, 0.009, 1.001, -1.0, std::nan("")})
    EXPECT_THROW(feeder.setSpeed(share, 0.1), InvalidInput) << share;
  EXPECT_EQ(speedRefusal(1.2, {}),
            "feed is 1.2; must be from 0.01 to 1, 1 is as planned; feeder.feed_most allows more, up to 3");
  EXPECT_NEAR(feeder.restTime(), timed.duration(), 1e-9);
}

/// Whether no waypoint is gone back to, and none is left out, from sample to sample.
bool passesWaypointsInOrder(const TrajectoryFeeder& feeder, const Toolpath& toolpath) {
  const auto number = [&](const WaypointIndex& at) {
    std::size_t before = 0;
    for (std::size_t p = 0; p < at.path; ++p) before += toolpath.layers[0].paths[p].motionCount();
    return before + (at.waypoint == 0 ? toolpath.layers[0].paths[at.path].motionCount() : at.waypoint);
  };
  std::size_t last = 0;
  JointState before = feeder.at(0.0);
  for (double t = 0.0; t < feeder.restTime(); t += kStep) {
    const JointState state = feeder.at(t);
    const std::size_t here = number(state.heading_for);
    if (here < last) return false;
    last = here;
    for (Eigen::Index j = 0; j < 4; ++j) {
      const double limit = TiltingGantry().joints()[static_cast<std::size_t>(j)].max_speed;
      if (std::abs(state.position[j] - before.position[j]) > (1.0 + 1e-6) * limit * kStep) return false;
    }
    before = state;
  }
  return true;
}

TEST(TrajectoryFeeder, ChangesItsSpeedAnywhereAndLaysEverythingOnce) {
  EXPECT_TRUE(rc::check("a job at changing speeds lays what it would without, within limits", [] {
    Toolpath toolpath = test::randomToolpath(*rc::gen::arbitrary<std::uint64_t>());
    toolpath.layers.resize(1);
    auto& paths = toolpath.layers[0].paths;
    paths.resize(std::min<std::size_t>(paths.size(), 2));
    const TimingSettings settings = powderSettings(*rc::gen::element(0.0, 0.01));
    const TimedPath timed = timedGantry(toolpath, settings);
    TrajectoryFeeder feeder(timed, fastFeeder());
    double now_s = 0.0;
    for (int changes = 0; changes < 4; ++changes) {
      now_s += timed.duration() * 0.01 * *rc::gen::inRange(0, 40);
      const JointState before = feeder.at(now_s);
      feeder.setSpeed(*rc::gen::element(0.2, 0.5, 0.8, 1.0, 1.3, 2.0, 3.0), now_s);
      // What the controller has for the next moment is not touched.
      RC_ASSERT((feeder.at(now_s).position - before.position).norm() == 0.0);
      if (!*rc::gen::arbitrary<bool>()) continue;
      feeder.pause(now_s);
      if (feeder.state() != TrajectoryFeederState::Paused) continue;
      now_s = feeder.restTime() + 0.1;
      feeder.resume(now_s);
    }
    const Outcome outcome = outcomeOf(feeder, toolpath, settings, feeder.restTime());
    RC_ASSERT(std::abs(outcome.volume / totals(toolpath).deposited_mm3 - 1.0) < kVolumeTolerance);
    RC_ASSERT(outcome.farthest < 0.05 + 1e-6);
    RC_ASSERT(outcome.acceleration < 1.0 + 1e-6);
    RC_ASSERT(passesWaypointsInOrder(feeder, toolpath));
    const JointState end = feeder.at(feeder.restTime() + 1.0);
    RC_ASSERT((end.position - timed.at(1e9).position).norm() < 1e-9);
  }));
}

TEST(TrajectoryFeeder, LaysEachMillimetreOnce) {
  const double area = crossSection({0.4, 0.2});
  for (const double jerk_ramp_s : {0.0, 0.01}) {
    const TimedPath timed = timedGantry(trajectoryFeederLine(), powderSettings(jerk_ramp_s));
    TrajectoryFeeder feeder(timed, {});
    for (const double pause_s : {0.0, 0.3, 0.9, 1.6}) {
      feeder.pause(pause_s);
      feeder.resume(feeder.restTime() + 0.1);
    }
    const double step_s = 2e-5;
    double volume = 0.0;
    for (std::size_t i = 0; static_cast<double>(i) * step_s < feeder.restTime(); ++i) {
      const double middle_s = (static_cast<double>(i) + 0.5) * step_s;
      volume += step_s * feeder.at(middle_s).process.flow_mm3_s;
      if (i % 1000 != 0) continue;
      const double x = feeder.at(middle_s + 0.5 * step_s).position[0];
      ASSERT_NEAR(volume / area, x, 1e-5) << middle_s;
    }
    EXPECT_NEAR(volume / (30.0 * area), 1.0, 1e-6);
  }
}

/// Where the first motion of the second of two layers begins.
Point3 secondLayerOf(const Toolpath& toolpath) { return toolpath.layers[1].paths[0].points[0]; }

PathRole roleAt(const Toolpath& toolpath, const WaypointIndex& at) {
  return toolpath.layers.at(at.layer).paths.at(at.path).role;
}

TEST(TrajectoryFeeder, RestsInFrontOfALayerUntilItIsReleased) {
  const Toolpath toolpath = test::twoLayers();
  const TimedPath timed = timedGantry(toolpath, powderSettings());
  TrajectoryFeeder feeder(timed, {});
  ASSERT_TRUE(feeder.holdAtLayer(1, 0.0));
  EXPECT_TRUE(feeder.isHeld());
  EXPECT_EQ(feeder.state(), TrajectoryFeederState::Running);
  const double rest_s = feeder.restTime();
  EXPECT_LT(rest_s, timed.duration());
  while (feeder.next(1e6)) continue;
  EXPECT_EQ(feeder.state(), TrajectoryFeederState::Running) << "there is more to come";
  const TiltingGantry gantry;
  const JointState rest = feeder.at(rest_s + 5.0);
  EXPECT_EQ(rest.velocity.norm(), 0.0);
  EXPECT_EQ(rest.process, safeSignals());
  const Point3 tip = gantry.bedFromNozzle(rest.position).translation();
  EXPECT_LT((tip - secondLayerOf(toolpath)).norm(), 1e-6);
  EXPECT_EQ(rest.heading_for.layer, 0U);
  EXPECT_EQ(roleAt(toolpath, rest.heading_for), PathRole::Travel);
  EXPECT_FALSE(feeder.holdAtLayer(1, 0.0)) << "it is held already";
  feeder.release(rest_s + 7.0);
  EXPECT_FALSE(feeder.isHeld());
  EXPECT_NEAR(feeder.restTime(), timed.duration() + 7.0, 1.0);
  EXPECT_FALSE(feeder.holdAtLayer(1, rest_s + 9.0)) << "it has begun";
  EXPECT_FALSE(feeder.holdAtLayer(2, rest_s + 9.0)) << "there is none";
  const Outcome outcome = outcomeOf(feeder, toolpath, powderSettings(), feeder.restTime());
  EXPECT_NEAR(outcome.volume / totals(toolpath).deposited_mm3, 1.0, kVolumeTolerance);
  EXPECT_LT(outcome.farthest, 0.05 + 1e-6);
  EXPECT_LT(outcome.acceleration, 1.0 + 1e-6);
}

TEST(TrajectoryFeeder, StillRestsInFrontOfALayerAtAnotherSpeed) {
  const Toolpath toolpath = test::twoLayers();
  const TimedPath timed = timedGantry(toolpath, powderSettings());
  TrajectoryFeeder feeder(timed, {});
  ASSERT_TRUE(feeder.holdAtLayer(1, 0.0));
  const double at_full_speed_s = feeder.restTime();
  feeder.setSpeed(0.5, 0.2);
  EXPECT_TRUE(feeder.isHeld());
  EXPECT_GT(feeder.restTime(), 1.5 * at_full_speed_s);
  const TiltingGantry gantry;
  const Point3 tip = gantry.bedFromNozzle(feeder.at(feeder.restTime()).position).translation();
  EXPECT_LT((tip - secondLayerOf(toolpath)).norm(), 1e-6);
}

/// The travel goes straight on from layer to layer: the motion does not rest where the layer begins.
TEST(TrajectoryFeeder, RestsOnTheTravelThatALayerBeginsWith) {
  const auto travel = [](const Point3& from, const Point3& to) {
    Path path = test::straightPath(from, to);
    path.role = PathRole::Travel;
    path.bead = Bead{};
    return path;
  };
  const Toolpath toolpath{
      "joined",
      {{0.2, 0.2, {test::straightPath({0, 0, 0.2}, {10, 0, 0.2}), travel({10, 0, 0.2}, {10, 20, 0.2})}},
       {0.4, 0.2, {travel({10, 20, 0.2}, {10, 40, 0.2}), test::straightPath({10, 40, 0.2}, {20, 40, 0.2})}}}};
  const TimedPath timed = timedGantry(toolpath, powderSettings());
  TrajectoryFeeder feeder(timed, {});
  ASSERT_TRUE(feeder.holdAtLayer(1, 0.0));
  const JointState rest = feeder.at(feeder.restTime() + 1.0);
  EXPECT_EQ(rest.velocity.norm(), 0.0);
  EXPECT_EQ(rest.heading_for.layer, 1U);
  EXPECT_EQ(roleAt(toolpath, rest.heading_for), PathRole::Travel);
}

/// One bead goes on from layer to layer: to stop there would leave a mark on it.
TEST(TrajectoryFeeder, DoesNotRestOnABeadThatGoesOnFromLayerToLayer) {
  const Toolpath toolpath{"endless",
                          {{0.2, 0.2, {test::straightPath({0, 0, 0.2}, {30, 0, 0.2})}},
                           {0.4, 0.2, {test::straightPath({30, 0, 0.2}, {60, 0, 0.2})}}}};
  const TimedPath timed = timedGantry(toolpath, powderSettings());
  TrajectoryFeeder feeder(timed, {});
  const double middle_s = 0.5 * timed.duration();
  ASSERT_GT(timed.at(middle_s).velocity.norm(), 1.0) << "it does not rest between the layers";
  EXPECT_FALSE(feeder.holdAtLayer(1, 0.0));
  EXPECT_FALSE(feeder.isHeld());
  EXPECT_EQ(feeder.restTime(), timed.duration());
  for (double time_s = 0.0; time_s < timed.duration(); time_s += 0.05)
    expectSame(feeder.at(time_s), timed.at(time_s));
}

/// Held in front of a layer, paused and resumed at any time on the way there or at rest: it ends in front of
/// the layer, and goes on only once it is released.
TEST(TrajectoryFeeder, IsHeldAgainOnceAPauseInFrontOfALayerIsOver) {
  ASSERT_TRUE(rc::check("a pause anywhere up to the layer", [] {
    const Toolpath toolpath = test::twoLayers();
    const TimedPath timed = timedGantry(toolpath, powderSettings(*rc::gen::element(0.0, 0.01)));
    TrajectoryFeeder feeder(timed, {});
    RC_ASSERT(feeder.holdAtLayer(1, 0.0));
    const double held_s = feeder.restTime();
    const double now_s = held_s * 0.001 * *rc::gen::inRange(1, 1100);
    while (feeder.next(now_s)) continue;
    feeder.pause(now_s);
    RC_ASSERT(feeder.state() == TrajectoryFeederState::Paused);
    feeder.release(now_s);
    RC_ASSERT(feeder.state() == TrajectoryFeederState::Paused);
    const double resume_s = feeder.restTime() + 1.0;
    feeder.resume(resume_s);
    RC_ASSERT(feeder.state() == TrajectoryFeederState::Running);
    RC_ASSERT(feeder.isHeld() || feeder.holdAtLayer(1, resume_s));
    const double rest_s = feeder.restTime();
    RC_ASSERT(feeder.at(rest_s + 100.0).heading_for.layer == 0U);
    feeder.release(std::max(resume_s, rest_s) + 1.0);
    RC_ASSERT(!feeder.isHeld());
    const Outcome outcome = outcomeOf(feeder, toolpath, powderSettings(), feeder.restTime());
    RC_ASSERT(std::abs(outcome.volume / totals(toolpath).deposited_mm3 - 1.0) < kVolumeTolerance);
  }));
}

/// Before the rest in front of a layer, and while it rests there.
TEST(TrajectoryFeeder, PausesAndAbortsWhereItIsHeld) {
  const Toolpath toolpath = test::twoLayers();
  const TimedPath timed = timedGantry(toolpath, powderSettings());
  for (const bool rests : {false, true}) {
    TrajectoryFeeder feeder(timed, {});
    ASSERT_TRUE(feeder.holdAtLayer(1, 0.0));
    const double held_s = feeder.restTime();
    const double now_s = rests ? held_s + 1.0 : 0.2;
    feeder.pause(now_s);
    EXPECT_EQ(feeder.state(), TrajectoryFeederState::Paused) << rests;
    EXPECT_EQ(feeder.isHeld(), rests) << "a pause on the way ends it";
    EXPECT_EQ(feeder.restTime() < held_s, !rests);
    feeder.resume(held_s + 3.0);
    EXPECT_EQ(feeder.holdAtLayer(1, held_s + 3.0), !rests);
    ASSERT_TRUE(feeder.isHeld());
    EXPECT_EQ(feeder.restTime() > held_s, !rests) << "in front of the layer nothing moves";
    feeder.release(std::max(feeder.restTime(), held_s + 3.0) + 1.0);
    const Outcome outcome = outcomeOf(feeder, toolpath, powderSettings(), feeder.restTime());
    EXPECT_NEAR(outcome.volume / totals(toolpath).deposited_mm3, 1.0, kVolumeTolerance) << rests;
    TrajectoryFeeder aborted(timed, {});
    ASSERT_TRUE(aborted.holdAtLayer(1, 0.0));
    aborted.abort(now_s);
    EXPECT_EQ(aborted.state(), TrajectoryFeederState::Aborted);
    EXPECT_TRUE(isSafe(aborted, now_s, held_s + 5.0));
    EXPECT_EQ(aborted.restTime() < held_s, !rests);
  }
}

TEST(TrajectoryFeeder, ReplacesWhatIsQueuedWhenPaused) {
  // With jerk limited braking sets in steadily; without, at the first point that is replaced.
  const TimedPath timed = timedGantry(trajectoryFeederLine(), powderSettings(0.01));
  TrajectoryFeeder feeder(timed, {});
  while (feeder.next(0.3)) continue;
  feeder.pause(0.3);
  const auto chunk = feeder.next(0.3);
  ASSERT_TRUE(chunk);
  EXPECT_NEAR(chunk->points.front().time_s, 0.352, 1e-9) << "the first point after the reaction";
  expectSame(chunk->points.front(), timed.at(chunk->points.front().time_s));
  while (feeder.next(0.3)) continue;
  feeder.resume(5.0);
  const auto resumed = feeder.next(5.0);
  ASSERT_TRUE(resumed);
  EXPECT_GT(resumed->points.front().time_s, 5.0);
  EXPECT_EQ(resumed->points.front().velocity.norm(), 0.0);
}

TEST(TrajectoryFeeder, AnAbortIsSafeAtOnceAndBrakesOnThePath) {
  EXPECT_TRUE(rc::check("an abort anywhere", [] {
    const Toolpath toolpath = test::twoLayers();
    const TimingSettings settings = powderSettings(*rc::gen::element(0.0, 0.01));
    const TimedPath timed = timedGantry(toolpath, settings);
    TrajectoryFeeder feeder(timed, {});
    const double now_s = timed.duration() * 0.001 * *rc::gen::inRange(0, 1000);
    while (feeder.next(now_s)) continue;
    feeder.abort(now_s);
    RC_ASSERT(feeder.state() == TrajectoryFeederState::Aborted);
    RC_ASSERT(isSafe(feeder, now_s, feeder.restTime() + 1.0));
    RC_ASSERT(feeder.at(feeder.restTime() + 1e-9).velocity.norm() < 1e-9);
    const Outcome outcome = outcomeOf(feeder, toolpath, settings, feeder.restTime());
    RC_ASSERT(outcome.farthest < 0.05 + 1e-6);
    RC_ASSERT(outcome.acceleration < 1.0 + 1e-6);
    const auto chunk = feeder.next(now_s);
    if (chunk) RC_ASSERT(chunk->points.front().time_s <= now_s + 1e-9);
    feeder.resume(now_s + 10.0);
    RC_ASSERT(feeder.state() == TrajectoryFeederState::Aborted);
  }));
}

TEST(TrajectoryFeeder, AbortsWhilePausedAndBeforeTheStart) {
  const TimedPath timed = timedGantry(trajectoryFeederLine(), powderSettings());
  TrajectoryFeeder paused(timed, {});
  while (paused.next(0.3)) continue;
  paused.pause(0.3);
  const double rest_s = paused.restTime();
  paused.abort(0.31);
  EXPECT_EQ(paused.restTime(), rest_s) << "it brakes already";
  EXPECT_TRUE(isSafe(paused, 0.31, rest_s + 1.0));
  const auto chunk = paused.next(0.31);
  ASSERT_TRUE(chunk);
  EXPECT_LE(chunk->points.front().time_s, 0.31) << "queued points are replaced by safe ones";
  TrajectoryFeeder unstarted(timed, {250.0, 50, 0.5, 0.0});
  unstarted.abort(0.0);
  EXPECT_TRUE(isSafe(unstarted, 0.0, 2.0));
  EXPECT_NEAR(unstarted.at(2.0).position[0], 0.0, 1e-12);
  TrajectoryFeeder reacting(timed, {250.0, 50, 0.5, 0.3});
  reacting.abort(-0.1);
  EXPECT_NEAR(reacting.at(2.0).position[0], 0.0, 1e-12) << "what was not handed over needs no reaction";
}

TEST(TrajectoryFeeder, DoesNothingAfterTheEnd) {
  const TimedPath timed = timedGantry(trajectoryFeederLine(), powderSettings());
  TrajectoryFeeder feeder(timed, {});
  feeder.pause(timed.duration() + 1.0);
  feeder.abort(timed.duration() + 1.0);
  EXPECT_EQ(feeder.state(), TrajectoryFeederState::Running);
  EXPECT_NEAR(feeder.at(1e9).position[0], 30.0, 1e-12);
}

TEST(TrajectoryFeeder, LiftsTheToolAgainstItsToolAxisAfterAnAbort) {
  const Toolpath toolpath = trajectoryFeederLine();
  const TiltingGantry gantry;
  const double tilt = 0.5;
  const JointPath path =
      test::jointPathBy(toolpath, [&](const Point3& tip) { return gantry.valuesAt(tip, tilt); });
  const TimingSettings settings = powderSettings(0.01);
  const TimedPath timed(toolpath, path, gantry, settings);
  TrajectoryFeeder feeder(timed, {});
  feeder.abort(0.5, {20.0, 40.0}, gantry);
  const JointState end = feeder.at(feeder.restTime());
  const Eigen::Isometry3d pose = gantry.bedFromNozzle(end.position);
  EXPECT_NEAR(pose.translation().z() - 0.2, 20.0 * std::cos(tilt), 1e-3);
  EXPECT_NEAR(pose.translation().y(), 20.0 * std::sin(tilt) * (pose.linear()(1, 2) > 0 ? -1 : 1), 1e-3);
  EXPECT_NEAR(end.position[3], tilt, 1e-4);
  EXPECT_TRUE(isSafe(feeder, 0.5, feeder.restTime() + 1.0));
}

TEST(TrajectoryFeeder, ALiftOutOfReachLeavesTheAbortStanding) {
  const TimedPath timed = timedGantry(trajectoryFeederLine(), powderSettings());
  TrajectoryFeeder feeder(timed, {});
  EXPECT_THROW(feeder.abort(0.5, {5000.0, 40.0}, TiltingGantry()), Unreachable);
  EXPECT_EQ(feeder.state(), TrajectoryFeederState::Aborted);
  EXPECT_EQ(feeder.at(0.51).process, safeSignals());
  EXPECT_EQ(feeder.at(feeder.restTime() + 1.0).velocity.norm(), 0.0);
}

}  // namespace
}  // namespace lamina
