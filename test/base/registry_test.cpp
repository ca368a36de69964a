// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/registry.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace lamina {
namespace {

TEST(Registry, FindsWhatIsBuiltInAndWhatWasAdded) {
  Registry<int> registry("wheel.count", {{"tricycle", 3}, {"bicycle", 2}});
  registry.add("car", 4);
  EXPECT_EQ(registry.find("tricycle"), 3);
  EXPECT_EQ(registry.find("car"), 4);
  EXPECT_EQ(registry.names(), (std::vector<std::string>{"bicycle", "car", "tricycle"}));
}

TEST(Registry, RefusesATakenNameAndKeepsTheEntry) {
  Registry<int> registry("wheel.count", {{"bicycle", 2}});
  EXPECT_THROW(registry.add("bicycle", 5), InvalidConfig);
  EXPECT_THROW(registry.add("", 5), InvalidConfig);
  EXPECT_EQ(registry.find("bicycle"), 2);
}

TEST(Registry, NamesTheKnownOnesWhereANameIsUnknown) {
  const Registry<int> registry("wheel.count", {{"tricycle", 3}, {"bicycle", 2}});
  try {
    registry.find("sledge");
    FAIL() << "nothing thrown";
  } catch (const InvalidConfig& error) {
    EXPECT_STREQ(error.what(), "wheel.count is 'sledge'; must be one of bicycle | tricycle");
  }
}

TEST(Registry, ForgetsWhatIsTakenBack) {
  Registry<int> registry("wheel.count", {});
  registry.add("car", 4);
  registry.remove("car");
  registry.remove("car");
  EXPECT_FALSE(registry.has("car"));
}

TEST(Registry, TakesEntriesFromSeveralThreads) {
  Registry<int> registry("wheel.count", {});
  const auto add = [&](const std::string& name) {
    for (int i = 0; i < 100; ++i) registry.add(name + std::to_string(i), i);
  };
  std::thread other(add, "a");
  add("b");
  other.join();
  EXPECT_EQ(registry.names().size(), 200U);
}

}  // namespace
}  // namespace lamina
