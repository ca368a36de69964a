// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The mode Manual of cell_controller, before a driver that only hears what it is told.
#include <geometry_msgs/TwistStamped.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>

#include <string>
#include <vector>

#include "messages.hpp"
#include "names.hpp"
#include "ros/cell/cell_of_nodes.hpp"
#include "ros/wait_until.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

using test::CellOfNodes;
using test::kAccepted;
using test::waitUntil;
using Order = lamina_msgs::MoveByHand::Request;

/// What a driver hears, and hands that ask for it.
class HeardByDriver {
 public:
  explicit HeardByDriver(const std::string& space) : node_(space) {
    const boost::function<void(const geometry_msgs::TwistStampedConstPtr&)> on_twist =
        [this](const auto& message) { twists.push_back(*message); };
    const boost::function<void(const sensor_msgs::JointStateConstPtr&)> on_joints =
        [this](const auto& message) { joints.push_back(*message); };
    const boost::function<void(const lamina_msgs::ManualStateConstPtr&)> on_state =
        [this](const auto& message) { state = *message; };
    subscribers_ = {node_.subscribe<geometry_msgs::TwistStamped>(names::kJogTwist, 100, on_twist),
                    node_.subscribe<sensor_msgs::JointState>(names::kJogJoints, 100, on_joints),
                    node_.subscribe<lamina_msgs::ManualState>(names::kManualState, 100, on_state)};
  }
  void comes() {
    publisher_ = node_.advertise<lamina_msgs::JogState>(names::kJogState, 1, true);
    lamina_msgs::JogState jog;
    jog.joints = {"joint_1", "rail"};
    jog.is_linear = {0, 1};
    publisher_.publish(jog);
  }
  int take(const std::string& source) {
    Order order;
    order.request = Order::TAKE;
    order.source = source;
    const int result = ask(order);
    if (result == kAccepted) lease = answer.lease;
    return result;
  }
  int steps(const std::string& source, const std::string& frame, const std::string& axis, double step) {
    Order order;
    order.request = Order::STEP;
    order.source = source;
    order.lease = lease;
    order.frame = frame;
    order.axis = axis;
    order.step = step;
    order.speed = 0.01;
    return ask(order);
  }
  bool rests() {
    return waitUntil([&] {
      const bool has_twist = twists.empty() || twists.back().twist.linear.z == 0.0;
      return has_twist && (joints.empty() || joints.back().velocity.at(0) == 0.0);
    });
  }

  std::vector<geometry_msgs::TwistStamped> twists;
  std::vector<sensor_msgs::JointState> joints;
  lamina_msgs::ManualState state;
  lamina_msgs::MoveByHand::Response answer;
  std::uint64_t lease = 0;

 private:
  int ask(const Order& order) {
    lamina_msgs::MoveByHand call;
    call.request = order;
    if (!callService(node_.resolveName(names::kMoveByHand), call)) return 0;
    answer = call.response;
    return answer.result;
  }

  ros::NodeHandle node_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Publisher publisher_;
};

TEST(ManualDesk, PassesStepsOfOneHolderToTheDriver) {
  CellOfNodes cell("by_hand", 1000.0);
  HeardByDriver driver("/by_hand");
  EXPECT_EQ(driver.take("page: anna"), 3) << "mode Production: " << driver.answer.message;
  ASSERT_TRUE(cell.setMode(3));
  EXPECT_EQ(driver.take("page: anna"), 6) << "no driver: " << driver.answer.message;
  driver.comes();
  ASSERT_TRUE(waitUntil([&] { return driver.state.joints.size() == 2; }));
  ASSERT_EQ(driver.take("page: anna"), kAccepted) << driver.answer.message;
  EXPECT_EQ(driver.take("page: ben"), 7) << "held by anna";
  EXPECT_NE(driver.answer.message.find("page: anna"), std::string::npos) << driver.answer.message;
  EXPECT_EQ(driver.steps("page: ben", "nozzle", "z", -0.002), 6) << "not his lease";
  EXPECT_EQ(driver.steps("page: anna", "nozzle", "z", -0.01), 8) << "a step of 1 s";
  EXPECT_TRUE(driver.twists.empty());
  EXPECT_EQ(driver.steps("page: anna", "nozzle", "z", -0.002), kAccepted) << driver.answer.message;
  ASSERT_TRUE(waitUntil([&] { return !driver.twists.empty(); }));
  EXPECT_EQ(driver.twists[0].header.frame_id, "nozzle");
  EXPECT_DOUBLE_EQ(driver.twists[0].twist.linear.z, -0.01);
  EXPECT_TRUE(waitUntil([&] { return driver.twists.back().twist.linear.z == 0.0; }));
  EXPECT_EQ(driver.steps("page: anna", "joints", "joint_1", 0.002), kAccepted) << driver.answer.message;
  ASSERT_TRUE(waitUntil([&] { return !driver.joints.empty(); }));
  EXPECT_EQ(driver.joints[0].name.at(0), "joint_1");
  EXPECT_DOUBLE_EQ(driver.joints[0].velocity.at(0), 0.01);
  EXPECT_TRUE(driver.rests());
  EXPECT_TRUE(cell.isInJournal("take the machine by hand"));
}

TEST(ManualDesk, RestsWhenTheLeaseIsLost) {
  CellOfNodes cell("hand_lost", 1000.0);
  HeardByDriver driver("/hand_lost");
  driver.comes();
  ASSERT_TRUE(cell.setMode(3));
  ASSERT_TRUE(waitUntil([&] { return driver.state.joints.size() == 2; }));
  ASSERT_EQ(driver.take("page: anna"), kAccepted) << driver.answer.message;
  ASSERT_EQ(driver.steps("page: anna", "bed", "z", 0.003), kAccepted) << driver.answer.message;
  ASSERT_TRUE(cell.setMode(1));
  ASSERT_TRUE(
      waitUntil([&] { return !driver.twists.empty() && driver.twists.back().twist.linear.z == 0.0; }));
  EXPECT_TRUE(waitUntil([&] { return driver.state.holder.empty(); }));
  EXPECT_NE(driver.state.reason.find("expected 3 (Manual)"), std::string::npos) << driver.state.reason;
  EXPECT_EQ(driver.steps("page: anna", "bed", "z", 0.003), 3) << driver.answer.message;
}

}  // namespace
}  // namespace lamina
