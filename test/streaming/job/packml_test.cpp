// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/job/packml.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

namespace lamina {
namespace {

using State = PackmlState;

/// The constants of msg/MachineState.msg by name.
std::map<std::string, int> messageConstants() {
  std::ifstream file(std::string(LAMINA_SOURCE_DIR) + "/msg/MachineState.msg");
  std::map<std::string, int> constants;
  for (std::string line; std::getline(file, line);) {
    const std::size_t equals = line.find('=');
    if (line.compare(0, 6, "uint8 ") != 0 || equals == std::string::npos) continue;
    constants[line.substr(6, equals - 6)] = std::stoi(line.substr(equals + 1));
  }
  return constants;
}

TEST(PackmlState, HasTheNumbersOfTheMessage) {
  const auto constants = messageConstants();
  ASSERT_EQ(constants.size(), 16U);
  for (int number = 0; number < 16; ++number) {
    std::string name = toString(static_cast<State>(number));
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    ASSERT_EQ(constants.count(name), 1U) << name;
    EXPECT_EQ(constants.at(name), number) << name;
  }
}

TEST(PackmlState, HasOneMoreThatTheMessageNamesInAComment) {
  std::ifstream file(std::string(LAMINA_SOURCE_DIR) + "/msg/MachineState.msg");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  EXPECT_NE(text.find("# UNSUSPENDING is 16"), std::string::npos);
  EXPECT_EQ(static_cast<int>(State::Unsuspending), 16);
  EXPECT_STREQ(toString(State::Unsuspending), "Unsuspending");
}

TEST(PackmlState, MovesAlongTheArrowsOfTheModelOnly) {
  EXPECT_TRUE(isLegalTransition(State::Execute, State::Holding));
  EXPECT_TRUE(isLegalTransition(State::Held, State::Unholding));
  EXPECT_TRUE(isLegalTransition(State::Clearing, State::Stopped));
  EXPECT_TRUE(isLegalTransition(State::Suspended, State::Unsuspending));
  EXPECT_TRUE(isLegalTransition(State::Unsuspending, State::Execute));
  EXPECT_FALSE(isLegalTransition(State::Suspended, State::Execute));
  EXPECT_FALSE(isLegalTransition(State::Idle, State::Execute));
  EXPECT_FALSE(isLegalTransition(State::Held, State::Execute));
  EXPECT_FALSE(isLegalTransition(State::Complete, State::Execute));
}

TEST(PackmlState, CanBeAbortedFromEverywhereButFromAborting) {
  for (int number = 0; number < 16; ++number) {
    const auto state = static_cast<State>(number);
    EXPECT_EQ(isLegalTransition(state, State::Aborting), state != State::Aborting && state != State::Aborted);
  }
}

}  // namespace
}  // namespace lamina
