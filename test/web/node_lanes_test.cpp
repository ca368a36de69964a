// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/node_lanes.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>

namespace lamina::test {
namespace {

constexpr double kPatient = 60.0;  // [s]

LaneOrder orderTo(const std::string& node, const std::string& kind, OrderEffect effect) {
  return {kind, effect, node, kPatient, [] { return DeskAnswer{}; }};
}

/// Lanes of a cell whose streamer hangs with an order that it was given.
class HangingStreamer {
 public:
  explicit HangingStreamer(OrderEffect effect) {
    LaneOrder order = orderTo("streamer", "hanging", effect);
    order.call = [this] {
      is_begun_.set_value();
      go_.get_future().wait();
      return DeskAnswer{};
    };
    hanging_ = std::async(std::launch::async, [this, order] { return lanes.give(order); });
    is_begun_.get_future().wait();
  }
  ~HangingStreamer() {
    if (hanging_.valid()) letGo();
  }
  HangingStreamer(const HangingStreamer&) = delete;
  HangingStreamer& operator=(const HangingStreamer&) = delete;

  DeskAnswer letGo() {
    go_.set_value();
    return hanging_.get();
  }

  NodeLanes lanes{{"cell", "streamer"}};

 private:
  std::promise<void> is_begun_;
  std::promise<void> go_;
  std::future<DeskAnswer> hanging_;
};

TEST(NodeLanes, StopsTheUnitWhileAnotherNodeHangsWithAStop) {
  HangingStreamer cell(OrderEffect::Stops);
  EXPECT_EQ(cell.lanes.give(orderTo("cell", "Stop", OrderEffect::Stops)).outcome, DeskAnswer::Outcome::Done);
  EXPECT_EQ(cell.lanes.give(orderTo("cell", "Start", OrderEffect::Moves)).outcome, DeskAnswer::Outcome::Done);
}

TEST(NodeLanes, GivesOrdersWhileAnotherNodeHangsWithOne) {
  HangingStreamer cell(OrderEffect::Other);
  EXPECT_EQ(cell.lanes.give(orderTo("cell", "Start", OrderEffect::Moves)).outcome, DeskAnswer::Outcome::Done);
  EXPECT_EQ(cell.lanes.give(orderTo("streamer", "Abort", OrderEffect::Stops)).outcome,
            DeskAnswer::Outcome::Done)
      << "a stop does not wait behind other orders to its node";
}

TEST(NodeLanes, StopsWhatIsOnItsWayToAnotherNode) {
  HangingStreamer cell(OrderEffect::Moves);
  EXPECT_EQ(cell.lanes.give(orderTo("cell", "Stop", OrderEffect::Stops)).outcome, DeskAnswer::Outcome::Done);
  const DeskAnswer overtaken = cell.letGo();
  EXPECT_EQ(overtaken.outcome, DeskAnswer::Outcome::Overtaken);
  EXPECT_EQ(overtaken.message,
            "hanging was on its way when Stop was asked for, which was given after it once more");
}

TEST(NodeLanes, StopsOnceMoreThoughAnotherNodeHangsWithAnEarlierStop) {
  std::atomic<int> aborts{0};
  std::atomic<int> holds{0};
  std::promise<void> is_begun;
  std::promise<void> go;
  HangingStreamer cell(OrderEffect::Stops);
  LaneOrder unhold = orderTo("cell", "Unhold", OrderEffect::Moves);
  unhold.call = [&] {
    is_begun.set_value();
    go.get_future().wait();
    return DeskAnswer{};
  };
  std::future<DeskAnswer> moving = std::async(std::launch::async, [&] { return cell.lanes.give(unhold); });
  is_begun.get_future().wait();
  LaneOrder abort = orderTo("streamer", "Abort", OrderEffect::Stops);
  abort.patience_s = 0.0;
  abort.call = [&] {
    ++aborts;
    return DeskAnswer{};
  };
  EXPECT_EQ(cell.lanes.give(abort).outcome, DeskAnswer::Outcome::Silent);
  LaneOrder hold = orderTo("cell", "Hold", OrderEffect::Stops);
  hold.call = [&] {
    ++holds;
    return DeskAnswer{};
  };
  EXPECT_EQ(cell.lanes.give(hold).outcome, DeskAnswer::Outcome::Done);
  go.set_value();
  EXPECT_EQ(moving.get().outcome, DeskAnswer::Outcome::Overtaken);
  EXPECT_EQ(cell.lanes.give(orderTo("cell", "Stop", OrderEffect::Stops)).outcome, DeskAnswer::Outcome::Done);
  EXPECT_EQ(holds, 2) << "once more, before the Stop";
  EXPECT_EQ(aborts, 0) << "it waits for the node that hangs";
}

TEST(NodeLanes, KnowsItsNodesFromTheBeginning) {
  NodeLanes lanes({"cell"});
  EXPECT_THROW(lanes.give(orderTo("streamer", "Abort", OrderEffect::Stops)), std::out_of_range);
}

}  // namespace
}  // namespace lamina::test
