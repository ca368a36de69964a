// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/cyclic_player.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <new>

#include "lamina/base/error.hpp"
#include "servo/servo_arm.hpp"

namespace lamina::test {
namespace {

thread_local std::size_t taken_from_heap = 0;

}  // namespace
}  // namespace lamina::test

void* operator new(std::size_t size) {
  ++lamina::test::taken_from_heap;
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++lamina::test::taken_from_heap;
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace lamina::test {
namespace {

constexpr double kCycle = 0.01;  // s

/// Of 100 cycles a second, sent 0.05 s ahead.
class NoSink final : public CyclicSink {
 public:
  double cycle() const override { return kCycle; }
  double ahead() const override { return 0.05; }
  void send(const CyclicTarget&) override {}
  void stop() override {}
};

/// A player that is asked cycle by cycle.
class Played {
 public:
  explicit Played(const JointValues& start, double begin_s = 0.0, CyclicSettings settings = fastBraking())
      : player(sixJoints(), settings, NoSink()), due_s(begin_s) {
    player.begin(start);
  }
  static CyclicSettings fastBraking() {
    CyclicSettings settings;
    settings.brake_s = 0.4;
    return settings;
  }
  /// Cycles up to a time, each of them late by so much.
  void runTo(double time_s, double late_s = 0.0) {
    while (due_s < time_s + 1e-6) {
      const JointValues before = player.target().now.position;
      const std::int64_t last = player.target().cycle;
      const CyclicTarget* const target = player.advance(due_s, due_s + late_s);
      if (target != nullptr && last > 0)
        widest = std::max(widest, (target->now.position - before).cwiseAbs().maxCoeff() /
                                      static_cast<double>(target->cycle - last));
      due_s += kCycle;
    }
  }
  std::string refusal(const TrajectoryChunk& chunk) {
    try {
      player.accept(chunk, due_s - kCycle);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  }
  double first() const { return player.target().now.position[0]; }

  CyclicPlayer player;
  double due_s;
  double widest = 0.0;  ///< way of a joint per cycle
};

/// From rest at 0 to rest at 1 rad, from 1 to 3 s.
TrajectoryChunk there() {
  return {{jointPoint(1.0, sixValues(0.0), sixValues(0.0)), jointPoint(3.0, sixValues(1.0), sixValues(0.0))}};
}

TEST(CyclicPlayer, PlaysTheCubicThroughItsPointsAndReportsWhatComes) {
  Played played(sixValues(0.0));
  ASSERT_EQ(played.refusal(there()), "");
  EXPECT_FALSE(played.player.isAtRest());
  played.runTo(0.99);
  EXPECT_EQ(played.first(), 0.0);
  EXPECT_EQ(played.player.target().cycle, 100);
  played.runTo(2.0);
  EXPECT_NEAR(played.first(), 0.5, 1e-9);
  EXPECT_NEAR(played.player.target().now.velocity[0], 0.75, 1e-9);
  // 3 u^2 - 2 u^3 at u = 0.525
  EXPECT_NEAR(played.player.target().ahead.position[0], 0.53746875, 1e-9);
  played.runTo(3.5);
  EXPECT_EQ(played.first(), 1.0);
  EXPECT_EQ(played.player.target().now.velocity[0], 0.0);
  EXPECT_TRUE(played.player.isAtRest());
  EXPECT_FALSE(played.player.fault());
}

TEST(CyclicPlayer, AChunkReplacesWhatIsLeftFromItsFirstPointOn) {
  Played played(sixValues(0.0));
  played.player.accept(sampledChunk(steadily, 0.0, 2.0, 0.1), 0.0);
  played.runTo(0.5);
  // Slower from 1 s on, to rest.
  ASSERT_EQ(played.refusal({{steadily(1.0), jointPoint(2.0, sixValues(1.5), sixValues(0.0))}}), "");
  played.runTo(0.9);
  EXPECT_NEAR(played.first(), 0.9, 1e-9);
  played.runTo(3.0);
  EXPECT_NEAR(played.first(), 1.5, 1e-9);
  EXPECT_FALSE(played.player.fault());
}

TEST(CyclicPlayer, BrakesAlongThePath) {
  Played line(sixValues(0.0));
  line.player.accept(sampledChunk(steadily, 0.0, 2.0, 0.1), 0.0);
  line.runTo(1.0);
  line.player.brake();
  line.runTo(1.1);
  EXPECT_TRUE(line.player.isBraking());
  // Half the greatest speed: rest in 0.2 s, within 0.1 rad.
  EXPECT_NEAR(line.first(), 1.075, 1e-9);
  EXPECT_NEAR(line.player.target().now.velocity[0], 0.5, 1e-9);
  EXPECT_NEAR(line.player.target().ahead.position[0], 1.1 - 0.5 * 0.05 * 0.25, 1e-9);
  line.runTo(1.5);
  EXPECT_NEAR(line.first(), 1.1, 1e-9);
  EXPECT_TRUE(line.player.isAtRest());
  EXPECT_FALSE(line.player.fault());

  Played circle(sixValues(0.5));
  circle.player.accept({{jointPoint(0.0, sixValues(0.5), sixValues(0.0)), round(0.2)}}, 0.0);
  circle.player.accept(sampledChunk(round, 0.2, 6.0, 0.02), 0.0);
  circle.runTo(1.0);
  circle.player.brake();
  while (!circle.player.isAtRest()) {
    circle.runTo(circle.due_s);
    EXPECT_NEAR(circle.player.target().now.position.norm(), 0.5, 1e-6);
  }
  // By the fastest joint, which is the first one: 0.4 s * 0.5 sin(angle) / 2, along half as much.
  const double angle = std::atan2(circle.player.target().now.position[1], circle.first());
  EXPECT_NEAR(angle, 1.0 + 0.05 * std::sin(angle), 1e-3);
}

TEST(CyclicPlayer, RestsOnItsPointsWhereTheyEndInMotion) {
  Played played(sixValues(0.0));
  played.player.accept(sampledChunk(steadily, 0.0, 2.0, 0.1), 0.0);
  played.runTo(4.0);
  EXPECT_LE(played.first(), 2.0);
  EXPECT_GE(played.first(), 2.0 - 2.0 * kCycle);
  EXPECT_TRUE(played.player.isAtRest());
  ASSERT_TRUE(played.player.fault());
  EXPECT_EQ(played.player.fault()->kind, CyclicFault::Kind::Starved);
  EXPECT_NE(faultText(*played.player.fault(), sixJoints()).find("no more points came"), std::string::npos);
  // The next motion begins without a fault.
  ASSERT_EQ(played.refusal({{jointPoint(4.5, played.player.target().now.position, sixValues(0.0)),
                             jointPoint(6.0, sixValues(1.5), sixValues(0.0))}}),
            "");
  EXPECT_FALSE(played.player.fault());
}

TEST(CyclicPlayer, GoesStraightOnOnlyWhereItsPointsEndTooSoon) {
  Played played(sixValues(0.0));
  played.player.accept(sampledChunk(steadily, 0.0, 0.05, 0.01), 0.0);
  played.runTo(1.0);
  EXPECT_NEAR(played.first(), 0.1, 1e-6) << "rest in 0.2 s from 1 rad/s";
  EXPECT_TRUE(played.player.isAtRest());
}

TEST(CyclicPlayer, NeverLeavesALimitOfAJoint) {
  Played played(sixValues(2.0), 2.0);
  played.player.accept(sampledChunk(steadily, 2.0, 2.95, 0.05), 2.0);
  played.runTo(2.5);
  TrajectoryChunk short_one = sampledChunk(steadily, 2.55, 2.98, 0.01);
  played.player.accept(short_one, 2.5);
  played.runTo(2.96);
  played.player.brake();
  played.runTo(4.0);
  EXPECT_LE(played.first(), 3.0);
  EXPECT_TRUE(played.player.isAtRest());
}

TEST(CyclicPlayer, BrakesWhenACycleComesTooLate) {
  for (const double late : {3.0, 3.5}) {
    Played played(sixValues(0.0));
    played.player.accept(sampledChunk(steadily, 0.0, 2.0, 0.1), 0.0);
    played.runTo(1.0);
    const std::int64_t before = played.player.target().cycle;
    played.player.advance(played.due_s,
                          played.due_s + (late + 1e-6) * kCycle - (late == 3.0 ? 2e-6 : 0.0) * kCycle);
    EXPECT_EQ(played.player.target().cycle, before + (late == 3.0 ? 3 : 4));
    EXPECT_EQ(played.player.isBraking(), late > 3.0);
    ASSERT_EQ(played.player.fault().has_value(), late > 3.0);
    if (late < 3.1) continue;
    EXPECT_EQ(played.player.fault()->kind, CyclicFault::Kind::Late);
    EXPECT_NE(faultText(*played.player.fault(), sixJoints()).find("s late; expected 0.03 s at most"),
              std::string::npos);
    played.due_s += 4.0 * kCycle;
    played.runTo(3.0);
    EXPECT_NEAR(played.first(), 1.04 + 0.1, 1e-9);
  }
}

TEST(CyclicPlayer, SendsNoCycleTwice) {
  Played played(sixValues(0.0));
  ASSERT_NE(played.player.advance(0.0, 0.021), nullptr);
  EXPECT_EQ(played.player.advance(0.02, 0.022), nullptr);
  ASSERT_NE(played.player.advance(0.03, 0.03), nullptr);
  EXPECT_EQ(played.player.target().cycle, 2);
}

TEST(CyclicPlayer, SendsNoTargetThatAJointCannotComeTo) {
  Played played(sixValues(0.0));
  TrajectoryChunk jump = sampledChunk(steadily, 0.0, 2.0, 0.1);
  for (std::size_t i = 10; i < jump.points.size(); ++i) jump.points[i].position[1] += 0.5;
  played.player.accept(jump, 0.0);
  played.runTo(3.0);
  ASSERT_TRUE(played.player.fault());
  EXPECT_EQ(played.player.fault()->kind, CyclicFault::Kind::Step);
  EXPECT_EQ(played.player.fault()->joint, 1U);
  EXPECT_NEAR(played.player.fault()->most, 2.0 * kCycle * 1.1, 1e-12);
  EXPECT_NE(faultText(*played.player.fault(), sixJoints()).find("joint 'joint_2' was to go"),
            std::string::npos);
  EXPECT_LE(played.widest, 2.0 * kCycle * 1.1);
  EXPECT_LT(played.first(), 1.15) << "0.9 s on, and half of 0.4 s";
  EXPECT_TRUE(played.player.isAtRest());
}

TEST(CyclicPlayer, RefusesMotionsThatItCannotPlay) {
  Played played(sixValues(0.0));
  played.runTo(0.5);
  const auto expects = [&](const TrajectoryChunk& chunk, const std::string& reason) {
    EXPECT_NE(played.refusal(chunk).find(reason), std::string::npos) << played.refusal(chunk);
  };
  expects({}, "without points");
  TrajectoryChunk twice = there();
  twice.points[1].time_s = 1.0;
  expects(twice, "point 1 is not later");
  TrajectoryChunk far = there();
  far.points[1].position[2] = 3.5;
  expects(far, "a point is at joint 'joint_3' 3.5, expected -3 to 3");
  far.points[1].position[2] = std::numeric_limits<double>::quiet_NaN();
  expects(far, "a point is at joint 'joint_3'");
  TrajectoryChunk fast = there();
  fast.points[1].velocity[0] = 2.1;
  expects(fast, "a point has the speed of joint 'joint_1' 2.1");
  expects({{jointPoint(1.0, sixValues(0.01), sixValues(0.0)), there().points[1]}},
          "the first point is not where the robot is: joint 'joint_1' 0.01");
  expects(
      {{jointPoint(0.1, sixValues(0.0), sixValues(0.0)), jointPoint(0.4, sixValues(0.0), sixValues(0.0))}},
      "the last point is 0.1 s in the past");
  expects(
      {{jointPoint(0.0, sixValues(0.0), sixValues(1.0)), jointPoint(1.0, sixValues(1.0), sixValues(1.0))}},
      "cannot be joined in time: joint 'joint_1' was to go 0.51");
  EXPECT_TRUE(played.player.isAtRest());
  const auto later = [](double time_s) {
    return jointPoint(time_s, sixValues(time_s - 1.0), sixValues(1.0));
  };
  ASSERT_EQ(played.refusal({{jointPoint(0.5, sixValues(0.0), sixValues(0.0)), later(2.0), later(3.0)}}), "");
  expects({{later(3.2), later(3.5)}}, "the first point is 0.2 s behind the end of the motion");
  played.runTo(2.5);
  EXPECT_FALSE(played.player.fault());
  played.player.brake();
  expects({{later(2.8), later(3.9)}}, "is being braked");
  played.runTo(2.6);
  expects({{later(2.8), later(3.9)}}, "is being braked");
}

TEST(CyclicPlayer, TakesSettingsWithinTheirBoundsOnly) {
  CyclicSettings settings;
  settings.brake_s = 0.0;
  EXPECT_THROW(CyclicPlayer(sixJoints(), settings, NoSink()), InvalidConfig);
  settings = {};
  settings.start_tolerance_deg = 1.0;
  Played played(sixValues(0.0), 0.0, settings);
  EXPECT_EQ(played.refusal({{jointPoint(0.5, sixValues(0.01), sixValues(0.0)), there().points[1]}}), "");
  settings = {};
  settings.late_cycles = 50.0;
  Played late(sixValues(0.0), 0.0, settings);
  late.player.accept(sampledChunk(steadily, 0.0, 2.0, 0.1), 0.0);
  late.runTo(1.0);
  late.player.advance(late.due_s, late.due_s + 0.45);
  EXPECT_FALSE(late.player.fault());
}

TEST(CyclicPlayer, TakesNoMemoryFromTheHeapInACycle) {
  Played played(sixValues(0.5));
  played.player.accept({{jointPoint(0.0, sixValues(0.5), sixValues(0.0)), round(0.2)}}, 0.0);
  played.player.accept(sampledChunk(round, 0.2, 4.0, 0.02), 0.0);
  const std::size_t before = taken_from_heap;
  played.runTo(2.0);
  played.player.brake();
  played.runTo(5.0);
  EXPECT_EQ(taken_from_heap, before);
  EXPECT_TRUE(played.player.isAtRest());
}

}  // namespace
}  // namespace lamina::test
