// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// An emulated machine that is given its port, filament, spacings and when its sensor measures.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/PointCloud2.h>
#include <sys/socket.h>

#include <cmath>
#include <set>

#include "lamina/streaming/session/stream_session.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "point_cloud.hpp"
#include "ros/node_process.hpp"
#include "ros/wait_until.hpp"

namespace lamina {
namespace {

constexpr double kFilament = 2.85;      // mm
constexpr double kPositionSpacing = 5;  // mm
constexpr double kProfileSpacing = 2;   // mm
constexpr double kExtruded = 1.9;       // mm of filament

/// One that nobody listens at.
int freePort() {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  EXPECT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
  EXPECT_EQ(getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
  close(listener);
  return ntohs(address.sin_port);
}

class ConfiguredMachine : public testing::Test {
 protected:
  void SetUp() override {
    const boost::function<void(const sensor_msgs::JointStateConstPtr&)> on_position =
        [this](const auto& message) { positions_.push_back(message); };
    const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> on_deposited =
        [this](const auto& message) { deposited_ = message; };
    subscribers_ = {node_.subscribe<sensor_msgs::JointState>(names::kMachinePosition, 20000, on_position),
                    node_.subscribe<sensor_msgs::PointCloud2>(names::kDeposited, 100, on_deposited)};
    // The first position is latched: from then on none is missed.
    ASSERT_TRUE(test::waitUntil([this] { return !positions_.empty(); }));
  }

  void measure() {
    const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> on_profile =
        [this](const auto& message) { profiles_.push_back(message); };
    subscribers_.push_back(node_.subscribe<sensor_msgs::PointCloud2>(names::kProfile, 20000, on_profile));
    // A profile is published only to those who are there.
    ASSERT_TRUE(test::waitUntil([this] {
      run("G1 X1 F6000\nG1 X0 F6000\n");
      return !profiles_.empty();
    }));
  }

  /// Streams a program, and waits until all of its motions are published.
  void run(const std::string& text) {
    const auto program = StreamableProgram::fromText("test", text);
    const StreamSession session(program, {}, {"tcp:127.0.0.1:" + std::to_string(port_), 0}, {});
    ASSERT_TRUE(session.waitFor(test::kPatience));
    ASSERT_EQ(session.status().state, PackmlState::Complete) << session.status().failure.message;
    ASSERT_TRUE(test::waitUntil([this] {
      lamina_msgs::MachineRest rest;
      rest_.call(rest);
      return rest.response.is_resting && !positions_.empty() &&
             positions_.back()->header.stamp == rest.response.last_position;
    }));
  }

  int port_ = freePort();
  test::NodeProcess machine_{
      LAMINA_MACHINE_NODE,
      {"__ns:=/configured", "_tcp_port:=" + std::to_string(port_), "_emulator/speed_up:=20",
       "_filament_diameter_mm:=2.85", "_position_spacing_mm:=5.0", "_profile_spacing_mm:=2.0",
       "_profile_while_depositing:=true"}};
  ros::NodeHandle node_{"configured"};
  ros::ServiceClient rest_ = node_.serviceClient<lamina_msgs::MachineRest>(names::kMachineRest);
  std::vector<ros::Subscriber> subscribers_;
  std::vector<sensor_msgs::JointStateConstPtr> positions_;
  std::vector<sensor_msgs::PointCloud2ConstPtr> profiles_;
  sensor_msgs::PointCloud2ConstPtr deposited_;
};

TEST_F(ConfiguredMachine, ListensAtItsPortAndReportsPositionsAtItsSpacing) {
  run("G28\nG90\nG1 X50 Y50 Z0.3 F6000\n");
  positions_.clear();
  run("G1 X150 F6000\n");
  std::set<int> reached;  // mm
  for (const auto& position : positions_) {
    const double x = 1000.0 * position->position[0];
    EXPECT_NEAR(x, std::round(x), 1e-6);
    reached.insert(static_cast<int>(std::round(x)));
  }
  for (int x = 55; x <= 150; x += static_cast<int>(kPositionSpacing)) EXPECT_EQ(reached.count(x), 1U) << x;
  EXPECT_LE(reached.size(), 21U) << "these, and where the motion began";
}

TEST_F(ConfiguredMachine, DepositsAsMuchAsItsFilamentIsThickAndMeasuresMeanwhile) {
  run("G28\nG90\nM83\nG1 X60 Y60 Z0.3 F6000\nG1 X100 E1.9 F1800\n");
  const double volume = kExtruded * M_PI / 4.0 * kFilament * kFilament;  // mm3
  std::set<std::pair<int, int>> columns;                                 // of 0.1 mm
  ASSERT_TRUE(test::waitUntil([&] {
    columns.clear();
    if (deposited_)
      for (const Point3& point : fromMessage(*deposited_, Eigen::Isometry3d::Identity()).points)
        columns.emplace(std::lround(10.0 * point.x() - 0.5), std::lround(10.0 * point.y() - 0.5));
    // The bead is 0.3 mm high throughout, but for its round sides.
    return static_cast<double>(columns.size()) * 0.01 * 0.3 > 0.97 * volume;
  })) << columns.size();
  EXPECT_LT(static_cast<double>(columns.size()) * 0.01 * 0.3, 1.2 * volume);

  measure();
  run("G1 Z0.6 F6000\nG1 X55 Y70 F6000\n");  // its sensor over the bead, at x = 80
  const ros::Time over = positions_.back()->header.stamp;
  const auto isMeasured = [&] { return profiles_.back()->header.stamp == positions_.back()->header.stamp; };
  run("G1 Y50 E1 F1800\n");
  ASSERT_TRUE(test::waitUntil(isMeasured));
  std::size_t count = 0;
  for (const auto& profile : profiles_) count += profile->header.stamp > over ? 1 : 0;
  EXPECT_EQ(count, static_cast<std::size_t>(20.0 / kProfileSpacing)) << "while it deposited";
}

}  // namespace
}  // namespace lamina
