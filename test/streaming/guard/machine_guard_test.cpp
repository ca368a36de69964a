// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/guard/machine_guard.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace lamina {
namespace {

constexpr int kStreamer = 100;  // its process
constexpr int kNext = 101;

MachinePulse atWork() { return {true, {"/dev/ttyUSB0", 115200}, "marlin", "/a.gcode", false, true}; }
MachinePulse startingUp() { return {true, {"/dev/ttyUSB0", 115200}, "marlin", "", false, false}; }
MachinePulse atRest() { return {false, {"/dev/ttyUSB0", 115200}, "marlin", "", false}; }

std::vector<GuardNewsKind> kindsOf(const std::vector<GuardNews>& news) {
  std::vector<GuardNewsKind> kinds;
  for (const GuardNews& each : news) kinds.push_back(each.kind);
  return kinds;
}
using Kinds = std::vector<GuardNewsKind>;

TEST(MachineGuard, WaitsForNothingBeforeAnybodyIsThere) {
  MachineGuard guard({});
  EXPECT_TRUE(std::isinf(guard.nextDeadline()));
  EXPECT_FALSE(guard.due(1e9));
}

TEST(MachineGuard, StopsAMachineInTheInstantItsStreamerDiesWithoutGrace) {
  MachineGuard guard({1.0, 0.0, 0.0, 2.0});
  guard.hear(atWork(), kStreamer, 10.0);
  EXPECT_FALSE(guard.due(10.04));
  guard.end(kStreamer, 10.05);
  EXPECT_EQ(guard.nextDeadline(), 10.05);
  const auto order = guard.due(10.05);
  ASSERT_TRUE(order);
  EXPECT_EQ(order->machine.port.name, "/dev/ttyUSB0");
  EXPECT_EQ(order->machine.program, "/a.gcode");
  EXPECT_EQ(order->hung_process, 0);
  EXPECT_EQ(kindsOf(guard.takeNews()), Kinds{GuardNewsKind::Lost});
  EXPECT_FALSE(guard.due(10.05)) << "it is ordered once";
}

TEST(MachineGuard, TellsTheLossAtOnceAndStopsWhenTheGraceIsOver) {
  MachineGuard guard({1.0, 10.0, 0.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  guard.end(kStreamer, 0.5);
  EXPECT_FALSE(guard.due(0.5));
  const auto news = guard.takeNews();
  ASSERT_EQ(kindsOf(news), Kinds{GuardNewsKind::Lost});
  EXPECT_EQ(news[0].message, "process 100 at /dev/ttyUSB0 has ended while it was at work");
  EXPECT_FALSE(guard.due(10.49));
  EXPECT_EQ(guard.nextDeadline(), 10.5);
  EXPECT_TRUE(guard.due(10.5));
}

TEST(MachineGuard, LeavesAMachineAtRestAlone) {
  MachineGuard guard({1.0, 0.0, 0.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  guard.hear(atRest(), kStreamer, 0.1);
  guard.end(kStreamer, 0.2);
  EXPECT_FALSE(guard.due(1e6));
  EXPECT_TRUE(guard.takeNews().empty());
}

TEST(MachineGuard, EndsAStreamerThatHangsBeforeItStopsTheMachine) {
  MachineGuard guard({1.0, 0.0, 0.0, 2.0});
  guard.hear(atWork(), kStreamer, 5.0);
  EXPECT_EQ(guard.nextDeadline(), 6.0);
  const auto order = guard.due(6.0);
  ASSERT_TRUE(order);
  EXPECT_EQ(order->hung_process, kStreamer);
  EXPECT_EQ(guard.takeNews().at(0).message,
            "process 100 at /dev/ttyUSB0 has said nothing for more than 1.0 s");
  guard.end(kStreamer, 6.1);
  EXPECT_TRUE(guard.takeNews().empty()) << "its end was meant";
}

TEST(MachineGuard, GivesAControllerThatFollowsTrajectoriesNoGrace) {
  MachineGuard guard({1.0, 10.0, 600.0, 2.0});
  MachinePulse driver = atWork();
  driver.firmware = kFollowsTrajectories;
  guard.hear(driver, kStreamer, 0.0);
  guard.end(kStreamer, 0.5);
  const auto order = guard.due(0.5);
  ASSERT_TRUE(order);
  EXPECT_EQ(order->machine.firmware, kFollowsTrajectories);
}

TEST(MachineGuard, ForgivesAStreamerThatHungForLessThanTheGrace) {
  MachineGuard guard({1.0, 10.0, 0.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  EXPECT_FALSE(guard.due(1.0));
  guard.hear(atWork(), kStreamer, 4.0);
  EXPECT_EQ(kindsOf(guard.takeNews()), (Kinds{GuardNewsKind::Lost, GuardNewsKind::Back}));
  EXPECT_FALSE(guard.due(4.9));
}

TEST(MachineGuard, GivesWhoCameBackWithoutTheWorkTheTimeUnattended) {
  MachineGuard guard({1.0, 10.0, 60.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  guard.end(kStreamer, 1.0);
  for (double now_s = 3.0; now_s < 63.0; now_s += 0.5) {
    guard.hear(atRest(), kNext, now_s);
    ASSERT_FALSE(guard.due(now_s)) << now_s;
  }
  EXPECT_EQ(kindsOf(guard.takeNews()), (Kinds{GuardNewsKind::Lost, GuardNewsKind::Back}));
  guard.hear(atRest(), kNext, 63.0);
  const auto order = guard.due(63.0);
  ASSERT_TRUE(order);
  EXPECT_TRUE(order->machine.is_at_work) << "it is the machine as the lost one left it";
  EXPECT_EQ(order->hung_process, 0);
}

TEST(MachineGuard, DropsTheMatterWhenTheWorkIsTakenUp) {
  MachineGuard guard({1.0, 10.0, 60.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  guard.end(kStreamer, 1.0);
  guard.hear(atRest(), kNext, 3.0);
  guard.hear(atWork(), kNext, 5.0);
  guard.hear(atRest(), kNext, 5.5);
  EXPECT_FALSE(guard.due(6.0));
  guard.hear(atRest(), kNext, 70.0);
  EXPECT_FALSE(guard.due(70.0));
}

TEST(MachineGuard, CountsTheGraceAnewForOneThatCameBackAndDied) {
  MachineGuard guard({1.0, 10.0, 600.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  guard.end(kStreamer, 1.0);
  guard.hear(atRest(), kNext, 3.0);
  guard.end(kNext, 3.5);
  EXPECT_FALSE(guard.due(13.4));
  EXPECT_TRUE(guard.due(13.5));
}

TEST(MachineGuard, TriesAgainUntilTheMachineHasConfirmed) {
  MachineGuard guard({1.0, 0.0, 0.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  guard.end(kStreamer, 1.0);
  ASSERT_TRUE(guard.due(1.0));
  guard.onStop({false, "no answer", false}, 4.0);
  EXPECT_EQ(guard.nextDeadline(), 6.0);
  ASSERT_TRUE(guard.due(6.0));
  guard.onStop({false, "no answer", false}, 7.0);
  ASSERT_TRUE(guard.due(9.0));
  guard.onStop({true, "at rest", true}, 10.0);
  EXPECT_EQ(kindsOf(guard.takeNews()),
            (Kinds{GuardNewsKind::Lost, GuardNewsKind::NotStopped, GuardNewsKind::Stopped}));
  EXPECT_FALSE(guard.due(1e6));
}

TEST(MachineGuard, TellsTwoStreamersApart) {
  MachineGuard guard({1.0, 10.0, 60.0, 2.0});
  for (double now_s = 0.0; now_s < 5.0; now_s += 0.5) {
    guard.hear(atWork(), kStreamer, now_s);
    guard.hear(atRest(), kNext, now_s);
  }
  EXPECT_TRUE(guard.takeNews().empty()) << "both live";
  guard.end(kStreamer, 5.0);
  guard.hear(atRest(), kNext, 5.1);
  EXPECT_EQ(kindsOf(guard.takeNews()), (Kinds{GuardNewsKind::Lost, GuardNewsKind::Back}));
}

TEST(MachineGuard, LetsNoStepOfAStartUpTakeUpAJob) {
  MachineGuard guard({1.0, 10.0, 60.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  guard.end(kStreamer, 1.0);
  for (double now_s = 3.0; now_s < 200.0; now_s += 0.5) {
    guard.hear(startingUp(), kNext, now_s);
    ASSERT_FALSE(guard.due(now_s)) << "somebody is at the machine, " << now_s;
  }
  for (double now_s = 200.0; now_s < 259.5; now_s += 0.5) {
    guard.hear(atRest(), kNext, now_s);
    ASSERT_FALSE(guard.due(now_s)) << now_s;
  }
  guard.hear(atRest(), kNext, 259.5);
  const auto order = guard.due(259.5);
  ASSERT_TRUE(order) << "60 s after the step";
  EXPECT_EQ(order->machine.program, "/a.gcode") << "as the lost one left it";
}

TEST(MachineGuard, StopsWhatTheJobHasUsedWhenAStartUpDiesAfterIt) {
  MachineGuard guard({1.0, 10.0, 60.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  guard.end(kStreamer, 1.0);
  guard.hear(startingUp(), kNext, 3.0);
  guard.end(kNext, 3.5);
  EXPECT_FALSE(guard.due(13.4));
  const auto order = guard.due(13.5);
  ASSERT_TRUE(order);
  EXPECT_EQ(order->machine.program, "/a.gcode");
}

TEST(MachineGuard, TellsAFailureAnewAfterSomebodyWasBack) {
  MachineGuard guard({1.0, 0.0, 60.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  guard.end(kStreamer, 1.0);
  ASSERT_TRUE(guard.due(1.0));
  guard.onStop({false, "no answer", false}, 2.0);
  guard.hear(atRest(), kNext, 3.0);
  guard.takeNews();
  for (double now_s = 3.5; now_s < 63.0; now_s += 0.5) guard.hear(atRest(), kNext, now_s);
  ASSERT_TRUE(guard.due(63.0));
  guard.onStop({false, "no answer", false}, 63.1);
  EXPECT_EQ(kindsOf(guard.takeNews()), Kinds{GuardNewsKind::NotStopped});
}

TEST(MachineGuard, TellsAJobThatGoesOnAfterTheStopHadBegun) {
  MachineGuard guard({1.0, 0.0, 60.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  guard.end(kStreamer, 1.0);
  ASSERT_TRUE(guard.due(1.0));
  guard.onStop({false, "no answer", true}, 2.0);
  guard.takeNews();
  guard.hear(atRest(), kNext, 3.0);
  guard.hear(atWork(), kNext, 3.5);
  const auto news = guard.takeNews();
  ASSERT_EQ(kindsOf(news), (Kinds{GuardNewsKind::Back, GuardNewsKind::Stopped}));
  EXPECT_EQ(news[1].message, "the stop had begun when process 101 at /dev/ttyUSB0 came back");
}

TEST(MachineGuard, BelievesWhoHungThatItIsAtRest) {
  MachineGuard guard({1.0, 10.0, 60.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  EXPECT_FALSE(guard.due(1.0));
  guard.hear(atRest(), kStreamer, 4.0);
  EXPECT_EQ(kindsOf(guard.takeNews()), (Kinds{GuardNewsKind::Lost, GuardNewsKind::Back}));
  guard.end(kStreamer, 4.5);
  EXPECT_FALSE(guard.due(1e6)) << "it has left the machine safe itself";
}

TEST(MachineGuard, EndsNoProcessThatHasEnded) {
  MachineGuard guard({1.0, 10.0, 60.0, 2.0});
  guard.hear(atWork(), kStreamer, 0.0);
  EXPECT_FALSE(guard.due(1.0));
  guard.end(kStreamer, 2.0);
  const auto order = guard.due(11.0);
  ASSERT_TRUE(order);
  EXPECT_EQ(order->hung_process, 0) << "its number may be another's";
}

TEST(MachineGuard, StopsAtItsEndWhatNobodyHasTakenUp) {
  MachineGuard guard({1.0, 10.0, 60.0, 2.0});
  EXPECT_FALSE(guard.dueAtEnd());
  guard.hear(atWork(), kStreamer, 0.0);
  EXPECT_FALSE(guard.dueAtEnd()) << "its streamer lives";
  guard.end(kStreamer, 1.0);
  EXPECT_TRUE(guard.dueAtEnd());
}

/// Streamers that come, work, rest, hang and die at random, and what is due then.
class AnyStreamers {
 public:
  explicit AnyStreamers(double grace_s) : guard_({1.0, grace_s, 0.0, 2.0}), grace_s_(grace_s) {}

  void happen(int what) {
    now_s_ += 0.01 * static_cast<double>(1 + what / 4 % 40);
    look();
    if (what % 4 == 0) beat(atWork());
    if (what % 4 == 1) beat(atRest());
    if (what % 4 == 2 && is_alive_) {
      guard_.end(process_, now_s_);
      die();
    }
    look();
  }

 private:
  void beat(const MachinePulse& pulse) {
    if (!is_alive_) ++process_;
    is_alive_ = true;
    heard_s_ = now_s_;
    is_at_work_ = pulse.is_at_work;
    guard_.hear(pulse, process_, now_s_);
    lost_s_.reset();  // whoever is back may leave the machine for ever, here
    if (is_at_work_) is_left_ = false;
  }

  void die() {
    is_alive_ = false;
    if (!is_at_work_ && !is_left_) return;
    is_left_ = true;
    lost_s_ = now_s_;
  }

  /// An order comes when, and only when, the loss of who had or has left a machine at work is as old as the
  /// grace.
  void look() {
    if (is_alive_ && now_s_ >= heard_s_ + 1.0) die();
    const bool is_due = lost_s_ && now_s_ >= *lost_s_ + grace_s_;
    const auto order = guard_.due(now_s_);
    RC_ASSERT(order.has_value() == is_due);
    if (!order) return;
    guard_.onStop({true, "", true}, now_s_);
    lost_s_.reset();
    is_left_ = false;
  }

  MachineGuard guard_;
  double grace_s_;
  double now_s_ = 0.0;
  int process_ = 0;
  bool is_alive_ = false;
  bool is_at_work_ = false;
  bool is_left_ = false;  ///< at work, by a lost one
  double heard_s_ = 0.0;
  std::optional<double> lost_s_;
};

RC_GTEST_PROP(MachineGuardProperty, OrdersAStopOnceForEachLossAtWorkAndForNothingElse,
              (const std::vector<unsigned char>& events, bool has_grace)) {
  AnyStreamers streamers(has_grace ? 0.7 : 0.0);
  for (const unsigned char what : events) streamers.happen(what);
}

}  // namespace
}  // namespace lamina
