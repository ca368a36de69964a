// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Toolpaths driven otherwise than planned: at other feeds, flows and powers, dry, and the machine moved by
// hand.
#include <geometry_msgs/TwistStamped.h>
#include <gtest/gtest.h>

#include "ros/node_process.hpp"
#include "two_beads.hpp"

namespace lamina {
namespace {

using lamina_msgs::Status;
using test::Deposit;
using test::depositOf;
using test::DriveCell;
using test::isOnBead;
using test::kHeight;
using test::twoBeads;
using test::waitUntil;

class ChangedDrive : public testing::TestWithParam<std::pair<const char*, const char*>> {
 protected:
  ChangedDrive() : cell(GetParam().first, GetParam().second) {}

  DriveCell cell;
};

/// By air, above the bead, with a pointer's tip on it, and at another speed; by a robot and a machine. Of
/// what is reported of the process nothing is ever on.
TEST_P(ChangedDrive, RunsDryWithNothingOfTheProcessOn) {
  struct DryCase {
    const char* dry;
    double speed;
    double above_mm;
  };
  const DryCase cases[] = {{"air", 2.0, 0.0}, {"lift", 0.0, 15.0}, {"point", 1.5, 40.0}};
  for (const DryCase& each : cases) {
    cell.dry = each.dry;
    cell.speed = each.speed;
    const std::size_t before = cell.reports.size();
    cell.drive(twoBeads());
    ASSERT_TRUE(cell.ends());
    ASSERT_EQ(cell.result().status.code, Status::OK + 0) << cell.result().status.message;
    ASSERT_TRUE(cell.comesTo("Complete")) << cell.state;
    ASSERT_TRUE(cell.staysSafe());
    double fastest = 0.0;
    std::size_t on_bead = 0;
    for (std::size_t i = before + 1; i < cell.reports.size(); ++i) {
      ASSERT_TRUE(DriveCell::isSafe(cell.reports[i])) << each.dry;
      const JointValues& joints = cell.reports[i].joints;
      const Eigen::Isometry3d nozzle = cell.model->bedFromNozzle(joints);
      const Point3 led = nozzle * Point3(0.0, 0.0, each.above_mm);
      if (!isOnBead(led, -1.0) || std::abs(led.x()) > 10.0) continue;
      ++on_bead;
      const double passed_s =
          (cell.reports[i].process.header.stamp - cell.reports[i - 1].process.header.stamp).toSec();
      const Point3 led_before =
          cell.model->bedFromNozzle(cell.reports[i - 1].joints) * Point3(0.0, 0.0, each.above_mm);
      fastest = std::max(fastest, (led - led_before).norm() / passed_s);
    }
    EXPECT_GT(on_bead, 10U) << each.dry;
    const double share = each.speed == 0.0 ? 1.0 : each.speed;
    EXPECT_NEAR(fastest, share * 30.0, 0.06 * share * 30.0) << each.dry;
  }
  cell.dry = "wet";
  cell.drive(twoBeads());
  ASSERT_TRUE(cell.ends());
  EXPECT_EQ(cell.result().status.code, Status::INVALID_INPUT + 0);
  cell.dry.clear();
  cell.speed = 0.5;
  cell.drive(twoBeads());
  ASSERT_TRUE(cell.ends());
  EXPECT_EQ(cell.result().status.code, Status::INVALID_INPUT + 0) << "a speed without a dry run";
}

/// A hand at a cell: sends orders, and hears what becomes of them.
class JogHand {
 public:
  explicit JogHand(const std::string& space) : node_(space) {
    joints_ = node_.advertise<sensor_msgs::JointState>(names::kJogJoints, 1);
    twist_ = node_.advertise<geometry_msgs::TwistStamped>(names::kJogTwist, 1);
    const boost::function<void(const lamina_msgs::JogStateConstPtr&)> on_state = [this](const auto& message) {
      state = *message;
    };
    state_ = node_.subscribe<lamina_msgs::JogState>(names::kJogState, 100, on_state);
  }
  bool isReady() {
    return waitUntil([&] { return joints_.getNumSubscribers() > 0 && twist_.getNumSubscribers() > 0; });
  }
  void turn(const std::string& joint, double rate) {
    sensor_msgs::JointState order;
    order.name = {joint};
    order.velocity = {rate};
    joints_.publish(order);
  }
  void move(const std::string& frame, double z_m_s) {
    geometry_msgs::TwistStamped order;
    order.header.frame_id = frame;
    order.twist.linear.z = z_m_s;
    twist_.publish(order);
  }
  bool letsGo() {
    return waitUntil([&] { return !state.moving && state.holder.empty(); });
  }

  lamina_msgs::JogState state;

 private:
  ros::NodeHandle node_;
  ros::Publisher joints_;
  ros::Publisher twist_;
  ros::Subscriber state_;
};

/// Along the tool axis and by a joint, after a job and before the next; it rests once no order comes.
TEST_P(ChangedDrive, IsMovedByHandBetweenJobsAndRestsWhenTheHandLetsGo) {
  JogHand hand(GetParam().first);
  ASSERT_TRUE(hand.isReady());
  cell.drive(twoBeads());
  ASSERT_TRUE(waitUntil([&] { return cell.isDepositing() || cell.isDone(); }));
  hand.move("nozzle", -0.01);
  ASSERT_TRUE(waitUntil([&] { return !hand.state.reason.empty(); }));
  EXPECT_EQ(hand.state.reason, "a job is under way; expected its end, or its abort, before a jog");
  ASSERT_TRUE(cell.ends());
  ASSERT_EQ(cell.result().status.code, Status::OK + 0) << cell.result().status.message;
  ASSERT_TRUE(cell.staysSafe());
  const std::size_t before = cell.reports.size() - 1;
  const Eigen::Isometry3d start = cell.model->bedFromNozzle(cell.reports[before].joints);
  const auto tipNow = [&] { return cell.tip(cell.reports.back()); };
  ASSERT_TRUE(waitUntil([&] {
    hand.move("nozzle", -0.02);
    return (tipNow() - start.translation()).norm() > 15.0;
  })) << hand.state.reason;
  EXPECT_TRUE(waitUntil([&] {
    hand.move("nozzle", -0.001);
    return hand.state.holder == ros::this_node::getName() && hand.state.frame == "nozzle";
  })) << hand.state.holder;
  ASSERT_TRUE(hand.letsGo());
  const ros::Time let_go = cell.reports.back().process.header.stamp + ros::Duration(0.5);
  ASSERT_TRUE(waitUntil([&] { return cell.reports.back().process.header.stamp > let_go; }));
  const std::size_t rested = cell.reports.size() - 1;
  const Point3 away = start.inverse() * cell.tip(cell.reports[rested]);
  EXPECT_LT(away.z(), -15.0);
  EXPECT_LT(away.head<2>().norm(), 0.2) << "along the tool axis";
  double fastest = 0.0;
  for (std::size_t i = before + 1; i < cell.reports.size(); ++i) {
    EXPECT_TRUE(DriveCell::isSafe(cell.reports[i]));
    const double passed_s =
        (cell.reports[i].process.header.stamp - cell.reports[i - 1].process.header.stamp).toSec();
    fastest =
        std::max(fastest, (cell.tip(cell.reports[i]) - cell.tip(cell.reports[i - 1])).norm() / passed_s);
  }
  EXPECT_LT(fastest, 20.0 * 1.1);
  const DrivenJoint& joint = cell.model->joints().front();
  const double joint_from = cell.reports.back().joints[0];
  const double rate = 0.05 * joint.max_speed;
  ASSERT_TRUE(waitUntil([&] {
    hand.turn(joint.name, joint.kind == JointKind::Linear ? rate / 1000.0 : rate);
    return cell.reports.back().joints[0] > joint_from + 0.2 * rate;
  })) << hand.state.reason;
  ASSERT_TRUE(hand.letsGo());
  hand.turn("no_such_joint", 0.1);
  EXPECT_TRUE(waitUntil([&] { return hand.state.reason.find("no_such_joint") != std::string::npos; }));
  ASSERT_TRUE(hand.letsGo());
  cell.drive(twoBeads());
  ASSERT_TRUE(cell.ends());
  EXPECT_EQ(cell.result().status.code, Status::OK + 0) << cell.result().status.message;
}

INSTANTIATE_TEST_SUITE_P(TrajectoryDriver, ChangedDrive,
                         testing::Values(std::pair{"arm", "irb_4600"},
                                         std::pair{"table", "five_axis_head_table"}),
                         [](const auto& machine) { return std::string(machine.param.first); });

/// With powder and laser, of which the paths state the power.
TEST(ChangedFeed, ChangesFeedFlowAndPowerWithoutAStop) {
  DriveCell cell("driverless", "five_axis_head_table");
  test::NodeProcess driver(
      LAMINA_DRIVER_NODE,
      {"__ns:=/driverless", "_machine/name:=five_axis_head_table", "_process/kind:=powder",
       "_feeder/points:=250", "_feeder/ahead_s:=4.0", "_feeder/reaction_s:=0.5", "_feeder/feed_most:=2.0",
       "_feeder/override_ramp_s:=0.2", "_start_delay_s:=0.2", "_tracking/silence_by:=stamps",
       "_approach/joint_speed:=1.0"});
  Toolpath part = twoBeads();
  for (const std::size_t bead : {0, 2}) part.layers[0].paths[bead].values = {{"laser_power_w", 1000.0}};
  cell.drive(part);
  ASSERT_TRUE(waitUntil([&] { return cell.isDepositing() || cell.isDone(); }));
  ASSERT_FALSE(cell.isDone()) << cell.result().status.message;
  for (const auto& [setting, share] :
       {std::pair("feed", 1.5), std::pair("flow", 1.2), std::pair("power", 0.8)}) {
    const Status answer = cell.change(setting, share);
    EXPECT_EQ(answer.code, Status::OK + 0) << setting << ": " << answer.message;
    EXPECT_EQ(answer.message, "");
  }
  EXPECT_EQ(cell.change("feed", 2.1).code, Status::INVALID_INPUT + 0) << "more than feeder.feed_most";
  EXPECT_EQ(cell.change("flow", 3.1).code, Status::INVALID_INPUT + 0);
  EXPECT_EQ(cell.change("babystep", 0.0).code, Status::INVALID_INPUT + 0);
  ASSERT_TRUE(waitUntil([&] { return !cell.isDepositing(); }));
  const std::size_t second = cell.reports.size();
  ASSERT_TRUE(cell.ends());
  ASSERT_EQ(cell.result().status.code, Status::OK + 0) << cell.result().status.message;
  EXPECT_EQ(cell.result().starvations, 0U);
  EXPECT_EQ(cell.change("feed", 1.0).code, Status::REJECTED + 0) << "the job is over";
  const Deposit fast = depositOf(cell, second, cell.reports.size());
  EXPECT_NEAR(fast.fastest_mm_s, 45.0, 1.5);
  const double planned = 1e-9 * 30.0 * crossSection(Bead{1.0, kHeight});  // m^3/s
  EXPECT_NEAR(fast.greatest_flow / planned, 1.5 * 1.2, 0.03);
  std::size_t burning = 0;
  for (std::size_t i = second; i < cell.reports.size(); ++i) {
    const auto& process = cell.reports[i].process;
    if (!process.laser) continue;
    ++burning;
    EXPECT_NEAR(process.laser_power, 800.0, 1e-6);
  }
  EXPECT_GT(burning, 10U);
}

}  // namespace
}  // namespace lamina
