// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "network/exposure.hpp"

#include <gtest/gtest.h>

namespace {

using lamina::Exposure;
using lamina::exposureWarnings;
using lamina::hostOfMaster;
using lamina::isLoopbackHost;

constexpr const char* kLocalMaster = "http://localhost:11311";

TEST(Exposure, KnowsHostsOnTheLoopbackInterface) {
  for (const char* host : {"localhost", "127.0.0.1", "127.1.2.3", "::1", "[::1]"})
    EXPECT_TRUE(isLoopbackHost(host)) << host;
  for (const char* host : {"", "robot", "192.168.0.127", "1270.0.0.1", "localhost.example.org"})
    EXPECT_FALSE(isLoopbackHost(host)) << host;
}

TEST(Exposure, FindsTheHostOfAMaster) {
  EXPECT_EQ(hostOfMaster("http://robot:11311/"), "robot");
  EXPECT_EQ(hostOfMaster("http://robot/"), "robot");
  EXPECT_EQ(hostOfMaster("robot:11311"), "robot");
  EXPECT_EQ(hostOfMaster("http://[::1]:11311"), "[::1]");
  EXPECT_EQ(hostOfMaster(""), "");
}

TEST(Exposure, IsNothingToWarnOfIfAllIsClosed) {
  EXPECT_TRUE(exposureWarnings({"127.0.0.1", kLocalMaster, {}, {{11311, true, 1}, {22, false, 2}}}).empty());
  EXPECT_TRUE(exposureWarnings({"192.168.0.5", "http://192.168.0.6:11311", {}, {{11311, false, 1}}}).empty());
}

TEST(Exposure, NamesOpenPortsOfTheNode) {
  const auto warnings = exposureWarnings({"192.168.0.5", "http://192.168.0.6:11311", {40001, 40002}, {}});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("40001, 40002"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("docs/cell/security.md"), std::string::npos) << warnings[0];
}

TEST(Exposure, NamesTheOpenPortOfAMasterOnThisHost) {
  const auto by_loopback = exposureWarnings({"127.0.0.1", kLocalMaster, {}, {{11311, false, 1}}});
  ASSERT_EQ(by_loopback.size(), 1U);
  EXPECT_NE(by_loopback[0].find("master's port 11311"), std::string::npos) << by_loopback[0];
  EXPECT_EQ(exposureWarnings({"192.168.0.5", "http://192.168.0.5:11312/", {}, {{11312, false, 1}}}).size(),
            1U);
}

TEST(Exposure, WarnsOfANodeThatNobodyReaches) {
  const auto warnings = exposureWarnings({"127.0.0.1", "http://robot:11311", {}, {}});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("ROS master on robot"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("ROS_IP"), std::string::npos) << warnings[0];
}

}  // namespace
