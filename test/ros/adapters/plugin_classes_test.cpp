// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_adapters/node_plugins.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "lamina/infill/strategy.hpp"

namespace {

TEST(PluginClasses, AreFoundThatPackagesExport) {
  ASSERT_FALSE(lamina::infillStrategies().has("dashes"));
  ::setenv("ROS_PACKAGE_PATH", LAMINA_PLUGIN_PACKAGE ":" LAMINA_PACKAGE, 1);
  ::setenv("CMAKE_PREFIX_PATH", LAMINA_PREFIX, 1);
  EXPECT_EQ(lamina::loadPluginClasses(), (std::vector<std::string>{"lamina_dashes/Dashes"}));
  EXPECT_TRUE(lamina::infillStrategies().has("dashes"));
  lamina::infillStrategies().remove("dashes");
}

}  // namespace
