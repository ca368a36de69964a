// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/plugin.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

TEST(Plugin, PathsStandBetweenColons) {
  EXPECT_EQ(pathsIn("/a/x.so:y.so"), (std::vector<std::string>{"/a/x.so", "y.so"}));
  EXPECT_EQ(pathsIn("::x.so:"), (std::vector<std::string>{"x.so"}));
  EXPECT_TRUE(pathsIn("").empty());
}

TEST(Plugin, ThoseOfTheEnvironmentAreInLaminaPlugins) {
  ::setenv("LAMINA_PLUGINS", "a.so:b.so", 1);
  EXPECT_EQ(pluginsOfEnvironment(), (std::vector<std::string>{"a.so", "b.so"}));
  ::unsetenv("LAMINA_PLUGINS");
  EXPECT_TRUE(pluginsOfEnvironment().empty());
}

TEST(Plugin, ThatIsNotThereIsNamed) {
  try {
    loadPlugins({"no/plugin.so"});
    FAIL() << "nothing thrown";
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("cannot load plug-in 'no/plugin.so': ", 0), 0U) << error.what();
  }
}

}  // namespace
}  // namespace lamina
