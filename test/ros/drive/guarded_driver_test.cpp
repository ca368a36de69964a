// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A driver that dies or hangs at work, and host_watch that stops the controller in its place.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "lamina/base/scratch_folder.hpp"
#include "ros/drive/two_beads.hpp"
#include "ros/node_process.hpp"

namespace lamina {
namespace {

using test::DriveCell;
using test::kHalf;
using test::twoBeads;
using test::waitUntil;

constexpr int kExecutorLost = 2201;
constexpr int kStoppedInItsPlace = 2203;

/// Driver and watch, with all of the motion handed over before it begins.
class GuardedDriver : public testing::TestWithParam<int> {
 protected:
  GuardedDriver() {
    const boost::function<void(const lamina_msgs::AlarmReportConstPtr&)> on_alarm =
        [this](const auto& report) { alarms.push_back(*report); };
    subscriber_ = node_.subscribe<lamina_msgs::AlarmReport>(names::kAlarmReports, 100, on_alarm);
  }

  bool isRaised(int id) const {
    return std::any_of(alarms.begin(), alarms.end(),
                       [id](const auto& report) { return report.id == id && !report.is_gone; });
  }
  bool isReady() {
    return waitUntil([&] { return std::filesystem::exists(socket) && subscriber_.getNumPublishers() > 0; });
  }

  ScratchFolder folder;
  std::string socket = folder.path() + "/driver.pulse";
  std::vector<lamina_msgs::AlarmReport> alarms;

 private:
  ros::NodeHandle node_{"driverless"};
  ros::Subscriber subscriber_;
};

TEST_P(GuardedDriver, HasItsControllerStopped) {
  DriveCell cell("driverless", "five_axis_head_table");
  // The grace is of streamers: a driver has none.
  const test::NodeProcess watch(LAMINA_WATCH_NODE,
                                {"__ns:=/driverless", "__name:=host_watch", "_guard/grace_s:=600",
                                 "_guard/socket:=" + socket, "_disk/folder:=" + folder.path()});
  test::NodeProcess driver(
      LAMINA_DRIVER_NODE,
      {"__ns:=/driverless", "__name:=trajectory_driver", "_guard/socket:=" + socket,
       "_machine/name:=five_axis_head_table", "_feeder/ahead_s:=60", "_start_delay_s:=0.2",
       "_tracking/silence_by:=stamps", "_approach/joint_speed:=1.0"});
  ASSERT_TRUE(isReady());
  cell.setSpeed(0.1);  // 36 s, of which a busy computer may lose many
  cell.drive(twoBeads());
  ASSERT_TRUE(waitUntil([&] { return cell.isDepositing(); }));
  EXPECT_FALSE(isRaised(kExecutorLost));
  kill(driver.id(), GetParam());
  ASSERT_TRUE(waitUntil([&] { return isRaised(kStoppedInItsPlace); }));
  EXPECT_TRUE(isRaised(kExecutorLost));
  EXPECT_EQ(driver.end(SIGKILL), -1) << "it is dead, or was killed since it hung";
  const Point3 stopped = cell.tip(cell.reports.back());
  EXPECT_GT((stopped - Point3(-kHalf, 35, test::kHeight)).norm(), 5.0) << "not at the end of the part";
  const std::size_t count = cell.reports.size();
  ASSERT_TRUE(waitUntil([&] { return cell.reports.size() > count + 100; }));
  EXPECT_LT((cell.tip(cell.reports.back()) - cell.tip(cell.reports[count + 50])).norm(), 1e-6) << "at rest";
}

INSTANTIATE_TEST_SUITE_P(Signals, GuardedDriver, testing::Values(SIGKILL, SIGSTOP));

}  // namespace
}  // namespace lamina
