// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Ten minutes of motion at 500 cycles a second, over a link that delays targets by up to 1 ms and loses some.
#include <gtest/gtest.h>

#include <deque>

#include "lamina/base/random.hpp"
#include "lamina/servo/cyclic_player.hpp"
#include "lamina/servo/servoj_follower.hpp"
#include "servo/servo_arm.hpp"

namespace lamina::test {
namespace {

constexpr double kStep = 0.002;     // s, a cycle
constexpr double kServoLag = 0.02;  // s

/// Of a robot's cycle and way ahead, which sends nothing.
class ServojTiming final : public CyclicSink {
 public:
  explicit ServojTiming(const ServojSettings& settings) : settings_(settings) {}
  double cycle() const override { return settings_.cycle(); }
  double ahead() const override { return settings_.ahead(); }
  void send(const CyclicTarget&) override {}
  void stop() override {}

 private:
  ServojSettings settings_;
};

/// From rest, joints that swing about the middle of an arm's reach; the tip goes by some 100 mm/s.
JointState swinging(double time_s) {
  JointState state = jointPoint(time_s, JointValues::Zero(6), JointValues::Zero(6));
  for (int j = 0; j < 6; ++j) {
    const double rate = 0.45 + 0.11 * j;
    const double width = 0.06 + 0.02 * j;
    state.position[j] = width * (1.0 - std::cos(rate * time_s));
    state.velocity[j] = width * rate * std::sin(rate * time_s);
  }
  return state;
}

/// Targets on their way to the robot.
class LossyLink {
 public:
  LossyLink(double jitter_s, double loss) : jitter_s_(jitter_s), loss_(loss) {}
  void send(const CyclicTarget& target, double now_s) {
    if (random_.uniform(0.0, 1.0) < loss_) return;
    // In order, as bytes of one connection come.
    last_s_ = std::max(last_s_, now_s + random_.uniform(0.0, jitter_s_));
    under_way_.push_back({last_s_, target});
  }
  void deliver(ServojFollower& robot, double now_s) {
    for (; !under_way_.empty() && under_way_.front().first <= now_s; under_way_.pop_front())
      robot.hear(under_way_.front().second);
  }

 private:
  double jitter_s_;
  double loss_;
  double last_s_ = 0.0;
  Random random_{20261120};
  std::deque<std::pair<double, CyclicTarget>> under_way_;
};

/// A host that plays a motion in chunks, well ahead, to a robot behind a link.
class Led {
 public:
  Led(double jitter_s, double loss)
      : player_(model_->joints(), {}, ServojTiming(settings_)),
        robot(settings_, kServoLag, swinging(0.0).position),
        link_(jitter_s, loss) {
    player_.begin(swinging(0.0).position);
  }
  /// A cycle of the host, and behind it one of the robot.
  void cycle(bool host_is_there = true) {
    const double due_s = kStep * count_++;
    if (host_is_there) {
      while (fed_s_ < due_s + 0.7) {
        player_.accept(sampledChunk(swinging, fed_s_, fed_s_ + 0.2, 0.004), due_s);
        fed_s_ += 0.2;
      }
      if (const CyclicTarget* const target = player_.advance(due_s, due_s)) link_.send(*target, due_s);
    }
    // Somewhere within the time that targets need.
    const double now_s = due_s + 0.0005;
    link_.deliver(robot, now_s);
    robot.cycle();
  }
  Eigen::Vector3d tip() const { return model_->bedFromNozzle(robot.position()).translation(); }
  Eigen::Vector3d tipAt(double time_s) const {
    return model_->bedFromNozzle(swinging(time_s).position).translation();
  }
  const CyclicPlayer& player() const { return player_; }

 private:
  std::unique_ptr<const KinematicModel> model_ = kinematicModelByName("irb_4600");
  ServojSettings settings_;
  CyclicPlayer player_;

 public:
  ServojFollower robot;

 private:
  LossyLink link_;
  double fed_s_ = 0.0;
  std::int64_t count_ = 0;
};

/// What is left of the distance between two motions less a constant delay of the one behind.
class Delayed {
 public:
  void add(const Eigen::Vector3d& ideal, const Eigen::Vector3d& velocity, const Eigen::Vector3d& actual) {
    along_ += velocity.dot(ideal - actual);
    squares_ += velocity.squaredNorm();
    offs_.push_back({ideal - actual, velocity});
  }
  double delay() const { return along_ / squares_; }
  double greatest() const {
    double greatest = 0.0;
    for (const auto& [off, velocity] : offs_)
      greatest = std::max(greatest, (off - delay() * velocity).norm());
    return greatest;
  }

 private:
  double along_ = 0.0;
  double squares_ = 0.0;
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> offs_;
};

TEST(LostTargets, CostNoCycleAndNoAccuracy) {
  constexpr int kCycles = 300000;
  Led ideal(0.0, 0.0);
  Led led(0.001, 0.01);
  Delayed error;
  double fastest = 0.0;
  for (int k = 0; k < kCycles; ++k) {
    const Eigen::Vector3d before = ideal.tip();
    ideal.cycle();
    led.cycle();
    if (k < 500) continue;
    const Eigen::Vector3d velocity = (ideal.tip() - before) / kStep;
    fastest = std::max(fastest, velocity.norm());
    error.add(ideal.tip(), velocity, led.tip());
  }
  EXPECT_GT(fastest, 100.0) << "mm/s";
  EXPECT_FALSE(led.player().fault());
  EXPECT_EQ(led.robot.report().state, ServojState::Following);
  EXPECT_GE(led.robot.following().cycles, kCycles - 5U);
  EXPECT_GT(led.robot.following().bridged, kCycles / 200U);
  EXPECT_EQ(led.robot.following().without, 0U) << "cycles without a target";
  EXPECT_LT(error.delay(), 0.002) << "s, that the link adds";
  EXPECT_LT(error.greatest(), 0.05) << "mm, beyond the servo's own lag";
  RecordProperty("greatest_um", static_cast<int>(1e3 * error.greatest()));
  RecordProperty("delay_us", static_cast<int>(1e6 * error.delay()));
}

TEST(LostTargets, ForTwentyMillisecondsStopTheRobotOnThePath) {
  for (const int when : {5000, 7300, 12000}) {
    Led led(0.001, 0.01);
    for (int k = 0; k < when; ++k) led.cycle();
    int cycles = 0;
    for (; led.robot.report().state == ServojState::Following; ++cycles) led.cycle(false);
    EXPECT_GE(cycles, 10);
    EXPECT_LE(cycles, 13);
    while (!led.robot.isAtRest()) led.cycle(false);
    double nearest = 1e9;
    for (double time_s = kStep * when - 0.1; time_s < kStep * when + 0.3; time_s += 1e-4)
      nearest = std::min(nearest, (led.tipAt(time_s) - led.tip()).norm());
    EXPECT_LT(nearest, 0.05) << "mm, off the path";
  }
}

}  // namespace
}  // namespace lamina::test
