// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node_diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include "ros/set_time.hpp"
#include "ros/wait_until.hpp"

namespace lamina {
namespace {

TEST(NodeDiagnostics, GoOnWhenRosTimeGoesBack) {
  const test::SetTime time;
  time.set(5000.0);
  int reports = 0;
  ros::NodeHandle node;
  const boost::function<void(const diagnostic_msgs::DiagnosticArrayConstPtr&)> on_report =
      [&](const auto& array) {
        for (const auto& status : array->status) reports += status.message == "is well" ? 1 : 0;
      };
  const auto subscriber = node.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 100, on_report);
  NodeDiagnostics diagnostics;
  diagnostics.begin("none", "part", [](auto& status) { status.summary(0, "is well"); });
  ASSERT_TRUE(test::waitUntil([&] { return subscriber.getNumPublishers() > 0; }));
  for (const double time_s : {5010.0, 5010.5, 100.0, 100.5}) {
    time.set(time_s);
    diagnostics.update();
  }
  EXPECT_TRUE(test::waitUntil([&] { return reports == 2; })) << "at 5010 s and at 100 s";
  time.set(101.5);
  diagnostics.update();
  EXPECT_TRUE(test::waitUntil([&] { return reports == 3; }));
}

}  // namespace
}  // namespace lamina
