// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/trajectory_driver/process_io_watch.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

std::string faultAt(double now_s) {
  ProcessIoDemand demand;
  demand.is_required = true;
  demand.silence_s = 0.5;
  lamina_msgs::ProcessReady ready;
  ready.ready = 1;
  return processFault(demand, ready, ros::Time(1000.0), ros::Time(now_s));
}

TEST(ProcessIoWatch, TakesNoWordOfBeforeRosTimeWentBack) {
  EXPECT_EQ(faultAt(1000.0), "");
  EXPECT_EQ(faultAt(999.9), "") << "clocks are set by little all the time";
  EXPECT_NE(faultAt(1000.6), "");
  EXPECT_NE(faultAt(900.0).find("100 s ahead of ROS time"), std::string::npos) << faultAt(900.0);
}

}  // namespace
}  // namespace lamina
