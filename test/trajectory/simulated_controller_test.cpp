// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/simulated_controller.hpp"

#include <gtest/gtest.h>

#include "lamina/base/manual_clock.hpp"
#include "support/joint_paths.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using test::TiltingGantry;

/// A zigzag whose beads take about ten minutes.
Toolpath tenMinutes() {
  Path path = test::straightPath({0, 0, 0.2}, {100, 0, 0.2});
  path.points.clear();
  for (int row = 0; row < 178; ++row) {
    path.points.emplace_back(row % 2 == 0 ? 0 : 100, 0.4 * row, 0.2);
    path.points.emplace_back(row % 2 == 0 ? 100 : 0, 0.4 * row, 0.2);
  }
  return {"zigzag", {{0.2, 0.2, {path}}}};
}

struct Job {
  TiltingGantry gantry;
  ManualClock clock;
  TimedPath timed;
  TrajectoryFeeder feeder;
  SimulatedController controller;

  Job(const Toolpath& toolpath, const ServoSettings& servo, const ControllerFaults& faults = {})
      : timed(toolpath, uprightPath(toolpath, gantry), gantry, {}),
        feeder(timed, {}),
        controller(clock, gantry, servo, timed.at(0.0).position, faults) {}

  /// Hands over every 50 ms.
  void runTo(double time_s) {
    while (clock.now() < time_s) {
      while (auto chunk = feeder.next(clock.now())) controller.accept(*chunk);
      clock.moveTo(clock.now() + 0.05);
      controller.advance();
    }
  }
};

Toolpath line() { return {"line", {{0.2, 0.2, {test::straightPath({0, 0, 0.2}, {90, 0, 0.2})}}}}; }

TEST(SimulatedController, IsNeverStarvedForTenMinutes) {
  Job job(tenMinutes(), {});
  ASSERT_GT(job.timed.duration(), 600.0);
  job.runTo(job.timed.duration() + 1.0);
  const TrackingReport report = job.controller.report();
  EXPECT_EQ(report.starvations, 0U);
  EXPECT_GE(report.least_queue_s, 0.5 - 0.05 - 1e-9) << "the motion ahead less the time between hand-overs";
  EXPECT_GE(report.cycles, 150000U);
  EXPECT_NEAR((job.controller.position() - job.timed.at(1e9).position).norm(), 0.0, 1e-6);
  EXPECT_EQ(job.controller.process(), safeSignals());
}

TEST(SimulatedController, ReportsWhenItWillRunOutInMotion) {
  Job job(line(), {});
  EXPECT_FALSE(job.controller.runsOutAt());
  job.runTo(0.5 * job.timed.duration());
  ASSERT_TRUE(job.controller.runsOutAt());
  EXPECT_NEAR(*job.controller.runsOutAt(), job.clock.now() + job.controller.queued(), 0.004 + 1e-9);
  job.runTo(job.timed.duration() - 0.1);
  EXPECT_FALSE(job.controller.runsOutAt()) << "what it has ends at rest";
}

TEST(SimulatedController, FollowsAtOnceWithoutLag) {
  ServoSettings servo;
  servo.lag_s = 0.0;
  Job job(line(), servo);
  job.runTo(job.timed.duration() + 0.5);
  EXPECT_EQ(job.controller.report().tip_greatest_mm, 0.0);
}

TEST(SimulatedController, LagsBySpeedTimesItsTimeConstant) {
  ServoSettings servo;
  servo.lag_s = 0.02;
  Job job(line(), servo);
  job.runTo(job.timed.duration() + 0.5);
  // A first-order lag held over cycles of T trails a ramp by v T q / (1 - q), q = exp(-T / lag).
  const double q = std::exp(-0.004 / 0.02);
  const double trailing = 30.0 * 0.004 * q / (1.0 - q);
  EXPECT_NEAR(job.controller.report().greatest[0], trailing, 1e-6);
  EXPECT_NEAR(job.controller.report().tip_greatest_mm, trailing, 1e-6);
  EXPECT_LT(job.controller.report().tip_rms_mm, trailing);
  EXPECT_NEAR(job.controller.report().greatest[1], 0.0, 1e-12);
}

TEST(SimulatedController, ASecondOrderLagTrailsByTwiceItsDamping) {
  ServoSettings servo;
  servo.lag_s = 0.02;
  servo.damping = 1.0;
  Job job(line(), servo);
  job.runTo(0.5 * job.timed.duration());
  const JointState asked = job.timed.at(job.clock.now());
  // 2 zeta lag v, less up to a cycle for which what is asked is held.
  EXPECT_NEAR(asked.position[0] - job.controller.position()[0], 2.0 * 0.02 * 30.0, 30.0 * 0.004);
  job.runTo(job.timed.duration() + 1.0);
  EXPECT_NEAR(job.controller.position()[0], 90.0, 1e-6);
}

TEST(SimulatedController, ALateChunkStarvesIt) {
  ControllerFaults faults;
  faults.late_chunk = 6;
  faults.late_s = 1.0;
  Job job(line(), {}, faults);
  job.runTo(job.timed.duration() + 2.0);
  EXPECT_EQ(job.controller.report().starvations, 1U);
  EXPECT_EQ(job.controller.report().least_queue_s, 0.0);
}

/// Expects the joint that moves to come to rest, slower by at most what its brakes give each cycle.
void expectBraked(Job& job, double deceleration) {
  double before = job.controller.velocity()[0];
  for (int cycle = 0; cycle < 250; ++cycle) {
    job.clock.moveTo(job.clock.now() + 0.004);
    job.controller.advance();
    const double speed = job.controller.velocity()[0];
    ASSERT_GE(speed - before, -deceleration * 0.004 - 1e-6);
    before = speed;
  }
  EXPECT_NEAR(before, 0.0, 1e-9);
}

TEST(SimulatedController, BrakesWhereThePointsEndInMotion) {
  ServoSettings servo;
  servo.lag_s = 0.0;
  servo.brake_s = 0.4;
  Job job(line(), servo);
  while (auto chunk = job.feeder.next(0.0)) job.controller.accept(*chunk);
  job.clock.moveTo(0.5);
  job.controller.advance();
  EXPECT_EQ(job.controller.report().starvations, 0U);
  expectBraked(job, job.gantry.joints()[0].max_speed / servo.brake_s);
  EXPECT_EQ(job.controller.report().starvations, 1U);
  EXPECT_EQ(job.controller.process(), safeSignals());
}

TEST(SimulatedController, BrakesFromWhereItIsWhenAskedTo) {
  ServoSettings servo;
  servo.lag_s = 0.0;
  Job job(line(), servo);
  job.runTo(1.0);
  job.controller.brake();
  expectBraked(job, job.gantry.joints()[0].max_speed / servo.brake_s);
  EXPECT_EQ(job.controller.report().starvations, 0U);
  EXPECT_EQ(job.controller.process(), safeSignals());
  EXPECT_LT(job.controller.position()[0], 35.0);
}

TEST(SimulatedController, AStopLeavesItWhereItIs) {
  ControllerFaults faults;
  faults.stop_s = 1.0;
  Job job(line(), {}, faults);
  job.runTo(1.0);
  const JointValues stopped = job.controller.position();
  job.runTo(2.0);
  EXPECT_EQ(job.controller.position(), stopped);
  EXPECT_TRUE(job.controller.report().is_stopped);
  EXPECT_EQ(job.controller.process(), safeSignals());
}

TEST(SimulatedController, AnAbortReachesItWithTheNextCycle) {
  Job job(line(), {});
  job.runTo(1.0);
  EXPECT_TRUE(job.controller.process().flow_mm3_s > 0.0);
  job.feeder.abort(job.clock.now(), {10.0, 20.0}, job.gantry);
  while (auto chunk = job.feeder.next(job.clock.now())) job.controller.accept(*chunk);
  job.clock.moveTo(job.clock.now() + 0.004);
  job.controller.advance();
  EXPECT_EQ(job.controller.process(), safeSignals());
  EXPECT_GT(job.controller.velocity()[0], 1.0) << "still on its way to rest";
  job.runTo(3.0);
  EXPECT_NEAR(job.controller.velocity().norm(), 0.0, 1e-6);
  EXPECT_NEAR(job.controller.position()[2], 10.2, 1e-3);
  EXPECT_EQ(job.controller.report().starvations, 0U);
}

TEST(SimulatedController, IsPausedAndResumedWithoutStarving) {
  Job job(line(), {});
  job.runTo(1.0);
  job.feeder.pause(job.clock.now());
  job.runTo(3.0);
  const JointValues paused = job.controller.position();
  EXPECT_LT(paused[0], 60.0);
  EXPECT_NEAR((paused - job.feeder.at(3.0).position).norm(), 0.0, 1e-6);
  job.feeder.resume(job.clock.now());
  job.runTo(job.feeder.restTime() + 1.0);
  EXPECT_NEAR(job.controller.position()[0], 90.0, 1e-6);
  EXPECT_EQ(job.controller.report().starvations, 0U);
  EXPECT_GT(job.controller.report().least_queue_s, 0.3);
}

}  // namespace
}  // namespace lamina
