// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/text.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(Text, LosesWhiteSpaceAtItsEndsOnly) {
  EXPECT_EQ(trimmed(" \t G1 X2\r\n"), "G1 X2");
  EXPECT_EQ(trimmed("G28"), "G28");
  EXPECT_EQ(trimmed(" \r\n"), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(Text, LosesTheMarkOfUtf8AtItsStartOnly) {
  EXPECT_EQ(withoutUtf8Mark("\xEF\xBB\xBFG28\xEF\xBB\xBF"), "G28\xEF\xBB\xBF");
  EXPECT_EQ(withoutUtf8Mark("\xEF\xBB"), "\xEF\xBB");
  EXPECT_EQ(withoutUtf8Mark(""), "");
}

TEST(Text, IsWrittenInSmallLetters) {
  EXPECT_EQ(lowerCase("RepRapFirmware 3.4 \xC4z@[`{"), "reprapfirmware 3.4 \xC4z@[`{");
  EXPECT_EQ(lowerCase(""), "");
}

TEST(Text, IsSplitIntoTheEntriesOfAList) {
  const std::vector<std::string> hosts = {"cell", "press 2", "plc"};
  EXPECT_EQ(listEntries("cell, press 2 ,,\tplc,"), hosts);
  EXPECT_EQ(listEntries("cell"), std::vector<std::string>(1, "cell"));
  EXPECT_TRUE(listEntries(" , ").empty());
  EXPECT_TRUE(listEntries("").empty());
}

TEST(Text, ListsNamesWithSeparatorsBetween) {
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(listed({"", "b"}, " | "), " | b");
  EXPECT_EQ(listed({}), "");
}

TEST(Text, IsBrokenBetweenWords) {
  const std::vector<std::string> lines = {"a part", "leans too", "far-out-there", "now"};
  EXPECT_EQ(brokenInto(9, "a part leans  too far-out-there now"), lines);
  EXPECT_EQ(brokenInto(9, ""), std::vector<std::string>(1));
}

TEST(Text, IsSplitAtWhiteSpace) {
  const std::vector<std::string> words = {"G28", "X", "Y"};
  EXPECT_EQ(splitIntoWords("  G28 X\t\nY "), words);
  EXPECT_TRUE(splitIntoWords(" \n").empty());
}

TEST(Text, CountsThingsInSentences) {
  EXPECT_EQ(countedSubject(1, "layer"), "1 layer was");
  EXPECT_EQ(countedSubject(0, "layer"), "0 layers were");
  EXPECT_EQ(countedSubject(12, "cloud"), "12 clouds were");
}

}  // namespace
}  // namespace lamina
