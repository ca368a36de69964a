// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/order_lane.hpp"

#include <gtest/gtest.h>

#include <future>
#include <thread>
#include <utility>
#include <vector>

namespace lamina::test {
namespace {

using Outcome = DeskAnswer::Outcome;
constexpr double kLong = 60.0;  // [s]

/// A lane that is held up by an order until it is let go.
class HeldUpLane {
 public:
  HeldUpLane()
      : first_(std::async(std::launch::async, [this] {
          return lane.ask({"first", OrderEffect::Other, "cell", kLong, [this] {
                             is_begun_.set_value();
                             go_.get_future().wait();
                             return DeskAnswer{};
                           }});
        })) {
    is_begun_.get_future().wait();
  }
  ~HeldUpLane() {
    if (first_.valid()) letGo();
  }
  HeldUpLane(const HeldUpLane&) = delete;
  HeldUpLane& operator=(const HeldUpLane&) = delete;

  Outcome letGo() {
    go_.set_value();
    return first_.get().outcome;
  }

  /// Asks in a thread: each order notes its kind when it is given.
  std::future<DeskAnswer> ask(const std::string& kind, OrderEffect effect, double patience_s = kLong) {
    return std::async(std::launch::async, [this, kind, effect, patience_s] {
      return lane.ask({kind, effect, "cell", patience_s, [this, kind] {
                         given.push_back(kind);
                         return DeskAnswer{};
                       }});
    });
  }
  void waitFor(std::size_t orders) const {
    while (lane.waiting() != orders) std::this_thread::yield();
  }

  OrderLane lane;
  std::vector<std::string> given;  // by the lane's thread; read once it has answered

 private:
  std::promise<void> is_begun_;
  std::promise<void> go_;
  std::future<DeskAnswer> first_;
};

TEST(OrderLane, DropsWhatWouldMoveTheUnitWhenItIsStopped) {
  HeldUpLane held;
  auto unhold = held.ask("Unhold", OrderEffect::Moves);
  held.waitFor(1);
  auto acknowledge = held.ask("acknowledgement of alarm 1001", OrderEffect::Other);
  held.waitFor(2);
  held.lane.dropMoves({"Hold", OrderEffect::Stops, "cell", kLong, {}});
  const DeskAnswer dropped = unhold.get();
  EXPECT_EQ(dropped.outcome, Outcome::Overtaken);
  EXPECT_EQ(dropped.message, "Unhold was not given: overtaken by Hold");
  EXPECT_EQ(held.letGo(), Outcome::Done) << "what is under way is not taken back";
  EXPECT_EQ(acknowledge.get().outcome, Outcome::Done);
  EXPECT_EQ(held.given, std::vector<std::string>{"acknowledgement of alarm 1001"});
  EXPECT_EQ(held.ask("Start", OrderEffect::Moves).get().outcome, Outcome::Done) << "asked for afterwards";
}

/// A lane on which Start is being given, and is answered so once it is let go.
std::pair<DeskAnswer, int> stoppedAmid(OrderEffect effect, Outcome outcome) {
  OrderLane lane;
  std::promise<void> is_begun;
  std::promise<void> go;
  auto start = std::async(std::launch::async, [&] {
    return lane.ask({"Start", effect, "cell", kLong, [&] {
                       is_begun.set_value();
                       go.get_future().wait();
                       DeskAnswer answer;
                       answer.outcome = outcome;
                       return answer;
                     }});
  });
  is_begun.get_future().wait();
  int stops = 0;
  lane.dropMoves({"Hold", OrderEffect::Stops, "cell", kLong, [&stops] {
                    ++stops;
                    return DeskAnswer{};
                  }});
  go.set_value();
  DeskAnswer answer = start.get();
  return {std::move(answer), stops};
}

TEST(OrderLane, GivesAStopOnceMoreAfterAnOrderThatWasOnItsWay) {
  for (const Outcome outcome : {Outcome::Done, Outcome::Silent}) {
    const auto [answer, stops] = stoppedAmid(OrderEffect::Moves, outcome);
    EXPECT_EQ(stops, 1);
    EXPECT_EQ(answer.outcome, Outcome::Overtaken);
    EXPECT_EQ(answer.message,
              "Start was on its way when Hold was asked for, which was given after it once more");
  }
  const auto [refused, stops_of_refused] = stoppedAmid(OrderEffect::Moves, Outcome::Refused);
  EXPECT_EQ(stops_of_refused, 0) << "nothing has moved";
  EXPECT_EQ(refused.outcome, Outcome::Refused);
  const auto [other, stops_of_other] = stoppedAmid(OrderEffect::Other, Outcome::Done);
  EXPECT_EQ(stops_of_other, 0);
  EXPECT_EQ(other.outcome, Outcome::Done);
}

TEST(OrderLane, GivesEachOfSeveralStopsOnceMore) {
  OrderLane lane;
  std::promise<void> is_begun;
  std::promise<void> go;
  auto step = std::async(std::launch::async, [&] {
    return lane.ask({"the next step", OrderEffect::Moves, "streamer", kLong, [&] {
                       is_begun.set_value();
                       go.get_future().wait();
                       return DeskAnswer{};
                     }});
  });
  is_begun.get_future().wait();
  std::vector<std::string> given;
  for (const char* kind : {"Stop", "Abort of the start-up", "Stop"})
    lane.dropMoves({kind, OrderEffect::Stops, "cell", kLong, [&given, kind] {
                      given.emplace_back(kind);
                      return DeskAnswer{};
                    }});
  go.set_value();
  const DeskAnswer answer = step.get();
  EXPECT_EQ(given, (std::vector<std::string>{"Abort of the start-up", "Stop"}));
  EXPECT_EQ(answer.outcome, Outcome::Overtaken);
  EXPECT_EQ(
      answer.message,
      "the next step was on its way when Abort of the start-up and Stop were asked for, which were given "
      "after it once more");
}

TEST(OrderLane, LetsOneOrderOfEachKindWait) {
  HeldUpLane held;
  auto start = held.ask("Start", OrderEffect::Moves);
  held.waitFor(1);
  const DeskAnswer second = held.ask("Start", OrderEffect::Moves).get();
  EXPECT_EQ(second.outcome, Outcome::Overtaken);
  EXPECT_EQ(second.message, "Start was not given: another waits for cell already");
  held.letGo();
  EXPECT_EQ(start.get().outcome, Outcome::Done);
  EXPECT_EQ(held.given.size(), 1U);
}

TEST(OrderLane, GivesOneHoldForAllThatAskForIt) {
  HeldUpLane held;
  auto hold = held.ask("Hold", OrderEffect::Stops);
  held.waitFor(1);
  EXPECT_EQ(held.ask("Hold", OrderEffect::Stops, 0.01).get().outcome, Outcome::Unsure)
      << "who is impatient takes it from nobody";
  EXPECT_EQ(held.lane.waiting(), 1U);
  held.lane.dropMoves({"Stop", OrderEffect::Stops, "cell", kLong, {}});
  held.letGo();
  EXPECT_EQ(hold.get().outcome, Outcome::Done);
  EXPECT_EQ(held.given, std::vector<std::string>{"Hold"});
}

TEST(OrderLane, BoundsHowManyWait) {
  HeldUpLane held;
  std::vector<std::future<DeskAnswer>> orders;
  for (int i = 0; i < 16; ++i) {
    orders.push_back(held.ask(std::to_string(i), OrderEffect::Other));
    held.waitFor(orders.size());
  }
  EXPECT_EQ(held.ask("one more", OrderEffect::Other).get().message,
            "one more was not given: 16 orders wait for cell; expected at most 16");
  held.letGo();
  for (auto& order : orders) EXPECT_EQ(order.get().outcome, Outcome::Done);
}

TEST(OrderLane, ReportsWhetherWhatWasNotAnsweredMayStillBeDone) {
  HeldUpLane held;
  const DeskAnswer silent = held.ask("mode", OrderEffect::Other, 0.01).get();
  EXPECT_EQ(silent.outcome, Outcome::Silent);
  EXPECT_EQ(silent.message, "cell has not answered; nothing was asked of it");
  held.letGo();
  EXPECT_TRUE(held.given.empty()) << "never given";
  std::promise<void> go;
  EXPECT_EQ(held.lane
                .ask({"slow", OrderEffect::Other, "cell", 1.0,
                      [&go] {
                        go.get_future().wait();
                        return DeskAnswer{};
                      }})
                .outcome,
            Outcome::Unsure);
  go.set_value();
}

}  // namespace
}  // namespace lamina::test
