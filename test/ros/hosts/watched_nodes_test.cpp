// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "nodes/host_watch/watch_settings.hpp"

namespace lamina {
namespace {

using Names = std::vector<std::string>;

HostWatchNodeSettings watching(const std::string& nodes) {
  HostWatchNodeSettings settings;
  settings.nodes = nodes;
  return settings;
}

TEST(WatchedNodes, AreThoseOfTheWatchsNamespaceUnlessTheirNamesAreFull) {
  const HostWatchNodeSettings settings = watching("gcode_streamer, /desk/slicing_service");
  EXPECT_EQ(watchedNodes(settings, "/cell_a"), (Names{"/cell_a/gcode_streamer", "/desk/slicing_service"}));
  EXPECT_EQ(watchedNodes(settings, "/"), (Names{"/gcode_streamer", "/desk/slicing_service"}));
  EXPECT_TRUE(watchedNodes(watching(""), "/cell_a").empty());
}

TEST(WatchedNodes, OfNamesThatNoNodeCanHaveAreRefused) {
  try {
    watchedNodes(watching("gcode-streamer"), "/");
    FAIL() << "expected a refusal";
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("nodes is 'gcode-streamer'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lamina
