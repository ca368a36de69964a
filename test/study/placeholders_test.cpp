// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/placeholders.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using Names = std::vector<std::string>;

TEST(Placeholders, AreNamesInBraces) {
  EXPECT_EQ(placeholdersIn("--set=a={x} {infill.pitch_mm}"), (Names{"x", "infill.pitch_mm"}));
  EXPECT_EQ(placeholdersIn("{{_a1}}"), Names{"_a1"});
  for (const char* text : {"", "{}", "{1}", "{a b}", "{\"a\": 1}", "{a", "a}", "{", "${}"})
    EXPECT_TRUE(placeholdersIn(text).empty()) << text;
}

TEST(Placeholders, AreReplacedOnceAndNothingElseIs) {
  EXPECT_EQ(filledIn("{a}-{b}{a}", {{"a", "1"}, {"b", "two"}}), "1-two1");
  EXPECT_EQ(filledIn("{a}", {{"a", "{b}"}, {"b", "no"}}), "{b}");
  EXPECT_EQ(filledIn("{\"x\": {x}}", {{"x", "0.5"}}), "{\"x\": 0.5}");
  EXPECT_EQ(filledIn("{a", {}), "{a");
  EXPECT_THROW(filledIn("{a} {missing}", {{"a", "1"}}), InvalidConfig);
}

RC_GTEST_PROP(Placeholders, LeaveTextWithoutBracesAlone, (const std::string& text)) {
  RC_PRE(text.find('{') == std::string::npos);
  RC_ASSERT(filledIn(text, {}) == text);
}

}  // namespace
}  // namespace lamina
