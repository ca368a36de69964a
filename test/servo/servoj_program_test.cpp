// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/servoj_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "lamina/base/error.hpp"
#include "lamina/servo/emulated_robot.hpp"

namespace lamina {
namespace {

TEST(ServojProgram, HoldsWhatIsSet) {
  const std::string text = servojProgram({}, "192.168.50.2", 50002);
  for (const char* const line :
       {"socket_open(\"192.168.50.2\", 50002, \"lamina\")", "t=CYCLE, lookahead_time=0.1, gain=300)",
        "  global CYCLE = 0.002\n", "  global AHEAD = 0.02\n", "  global SILENT_CYCLES = 10\n",
        "  global STOP = 10\n", "socket_read_binary_integer(25, \"lamina\"", "stopj(STOP)"})
    EXPECT_NE(text.find(line), std::string::npos) << line;
  ServojSettings other;
  other.controller = ServojController::Cb3;
  other.lookahead_s = 0.05;
  other.gain = 600;
  other.silence_s = 0.4;
  other.stop_rad_s2 = 4.0;
  const std::string changed = servojProgram(other, "127.0.0.1", 1);
  for (const char* const line :
       {"lookahead_time=0.05, gain=600)", "  global CYCLE = 0.008\n", "  global AHEAD = 0.1\n",
        "  global SILENT_CYCLES = 50\n", "  global STOP = 4\n"})
    EXPECT_NE(changed.find(line), std::string::npos) << line;
}

/// Each block ends, and lines keep to what controllers take.
TEST(ServojProgram, IsOneWholeFunction) {
  std::istringstream text(servojProgram({}, "192.168.50.2", 50002));
  int open = 0;
  int lines = 0;
  std::string line;
  std::string last;
  while (std::getline(text, line)) {
    ++lines;
    last = line;
    const std::string word = line.substr(
        line.find_first_not_of(' ') == std::string::npos ? line.size() : line.find_first_not_of(' '));
    const auto begins = [&word](const char* key) { return word.rfind(key, 0) == 0; };
    if (begins("def ") || begins("thread ") || begins("while ") || begins("if ")) {
      ++open;
      EXPECT_EQ(word.back(), ':') << line;
    }
    if (word == "end") --open;
    EXPECT_TRUE(open > 0 || lines > 1);
    EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; })) << line;
    EXPECT_EQ(line.find_first_of("{}"), std::string::npos) << line;
  }
  EXPECT_EQ(open, 0);
  EXPECT_EQ(last, "end");
}

TEST(ServojProgram, IsReadByTheEmulatedRobotWholeOnly) {
  ServojSettings settings;
  settings.controller = ServojController::Cb3;
  settings.silence_s = 0.04;
  settings.stop_rad_s2 = 7.5;
  const std::string text = servojProgram(settings, "127.0.0.1", 50003);
  const auto program = sentProgram(text);
  ASSERT_TRUE(program);
  EXPECT_EQ(program->host, "127.0.0.1");
  EXPECT_EQ(program->port, 50003);
  EXPECT_EQ(program->settings.controller, ServojController::Cb3);
  EXPECT_NEAR(program->settings.silence_s, 0.04, 1e-12);
  EXPECT_EQ(program->settings.stop_rad_s2, 7.5);
  for (std::size_t length = 0; length < text.size(); length += 7)
    EXPECT_FALSE(sentProgram(text.substr(0, length))) << length;
  const auto with = [&text](const std::string& part, const std::string& other) {
    std::string changed = text;
    return sentProgram(changed.replace(changed.find(part), part.size(), other)).has_value();
  };
  EXPECT_TRUE(with("50003", "50004"));
  EXPECT_FALSE(with("50003", "70000"));
  EXPECT_FALSE(with("STOP = 7.5", "STOP = ..."));
  EXPECT_FALSE(with("CYCLE = 0.008", "CYCLE = fast"));
  EXPECT_FALSE(sentProgram("def other():\n  textmsg(1)\nend\n"));
}

TEST(ServojProgram, RefusesSettingsBeyondWhatServojTakes) {
  for (const auto& [key, value] :
       {std::pair("servoj.gain", "50"), std::pair("servoj.gain", "2001"),
        std::pair("servoj.lookahead_s", "0.02"), std::pair("servoj.lookahead_s", "0.21"),
        std::pair("servoj.silence_s", "0.001"), std::pair("servoj.controller", "cb4"),
        std::pair("servoj.stop_rad_s2", "0")}) {
    ServojSettings settings;
    SettingsSchema schema;
    describe(schema, settings);
    EXPECT_THROW(schema.set(key, value), InvalidConfig) << key;
  }
}

}  // namespace
}  // namespace lamina
