// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Calls slicing_service, which found the plug-in of examples/plugin by pluginlib.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cstdlib>
#include <vector>

#include "messages.hpp"
#include "names.hpp"
#include "request_settings.hpp"
#include "ros/node_process.hpp"
#include "ros/wait_until.hpp"

namespace {

using lamina::settingMessage;
using lamina_msgs::SliceMesh;
using lamina_msgs::Status;

class NodePlugins : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(client_.waitForExistence(ros::Duration(lamina::test::kPatience))); }

  SliceMesh::Response slice(const std::string& part, const std::vector<lamina_msgs::Setting>& settings) {
    SliceMesh service;
    service.request.part = part;
    service.request.settings = settings;
    EXPECT_TRUE(client_.call(service)) << "the node does not answer";
    return service.response;
  }

  ros::NodeHandle node_;
  ros::ServiceClient client_ = node_.serviceClient<SliceMesh>(lamina::names::kSliceMesh);
};

/// Where no package exports the plug-in.
std::uint8_t dashedBy(const std::string& space, const std::vector<std::string>& arguments) {
  std::vector<std::string> all{"__ns:=/" + space};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const lamina::test::NodeProcess slicing(LAMINA_SLICING_NODE, all);
  ros::NodeHandle node(space);
  auto client = node.serviceClient<SliceMesh>(lamina::names::kSliceMesh);
  EXPECT_TRUE(client.waitForExistence(ros::Duration(lamina::test::kPatience)));
  SliceMesh service;
  service.request.part = "box";
  service.request.settings = {settingMessage("infill.strategy", "dashes")};
  EXPECT_TRUE(client.call(service));
  return service.response.status.code;
}

TEST(NodePluginPaths, AreTakenFromAParameter) {
  ::unsetenv("ROS_PACKAGE_PATH");
  EXPECT_EQ(dashedBy("bare", {}), Status::INVALID_CONFIG + 0);
  EXPECT_EQ(
      dashedBy("configured", {"_" + std::string(lamina::names::kPluginsParameter) + ":=" + LAMINA_DASHES}),
      Status::OK + 0);
}

TEST_F(NodePlugins, FillAPartOnRequest) {
  const auto dashed = slice("box", {settingMessage("infill.strategy", "dashes")});
  ASSERT_EQ(dashed.status.code, Status::OK + 0) << dashed.status.message;
  EXPECT_NE(dashed.toolpath_id, slice("box", {}).toolpath_id);
}

TEST_F(NodePlugins, StandAmongTheStrategiesThatARefusalNames) {
  const auto refused = slice("box", {settingMessage("infill.strategy", "spaghetti")});
  EXPECT_EQ(refused.status.code, Status::INVALID_CONFIG + 0);
  EXPECT_NE(refused.status.message.find("contour | cubic | dashes | drops_contour"), std::string::npos)
      << refused.status.message;
}

}  // namespace
