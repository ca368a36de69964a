// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/percent_encoding.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/edit_distance.hpp"

namespace lamina {
namespace {

TEST(PercentEncoding, WritesBytesThatAreNotKeptAsTwoDigits) {
  EXPECT_EQ(percentEncoded("a b/c%\xc3\xa9", "/"), "a%20b/c%25%C3%A9");
  EXPECT_EQ(percentEncoded("aZ09", ""), "aZ09");
}

TEST(PercentEncoding, ReadsBackAnyBytes) {
  EXPECT_TRUE(rc::check([](const std::string& text) {
    RC_ASSERT(percentDecoded(percentEncoded(text, " /+")) == std::optional<std::string>(text));
  }));
}

TEST(PercentEncoding, RefusesAnEscapeThatIsNone) {
  for (const char* text : {"%", "a%2", "%g0", "%0G", "%c"}) EXPECT_FALSE(percentDecoded(text)) << text;
  EXPECT_EQ(percentDecoded("%41%"), std::nullopt);
  EXPECT_EQ(percentDecoded("%41"), "A");
  EXPECT_EQ(percentDecoded("%c3%C3"), "\xc3\xc3");
}

TEST(EditDistance, CountsBytesPutInLeftOutAndReplaced) {
  EXPECT_EQ(editDistance("", ""), 0U);
  EXPECT_EQ(editDistance("abc", ""), 3U);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
  EXPECT_EQ(editDistance("Marlin 2.1", "Marlon 2.1"), 1U);
}

}  // namespace
}  // namespace lamina
