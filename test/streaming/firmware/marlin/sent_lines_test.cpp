// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/marlin/sent_lines.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

SentLines linesFrom(std::uint64_t first, std::uint64_t last) {
  SentLines lines;
  for (std::uint64_t number = first; number <= last; ++number) lines.add({number, 10, false, false, false});
  return lines;
}

TEST(SentLines, AreDoneOldestFirst) {
  SentLines lines = linesFrom(1, 3);
  EXPECT_EQ(lines.bytes(), 30U);
  EXPECT_EQ(lines.acknowledge(), 1U);
  EXPECT_EQ(lines.acknowledge(), 2U);
  EXPECT_EQ(lines.bytes(), 10U);
  EXPECT_EQ(lines.acknowledge(), 3U);
  EXPECT_EQ(lines.acknowledge(), std::nullopt);
  EXPECT_TRUE(lines.empty());
}

TEST(SentLines, AreDoneTogetherWhenTheOkHasANumber) {
  SentLines lines = linesFrom(1, 4);
  lines.acknowledgeUpTo(3);
  EXPECT_EQ(lines.count(), 1U);
  EXPECT_EQ(lines.acknowledge(), 4U);
}

TEST(SentLines, GoStaleBehindALostLineWhileTheOksOfThoseBeforeAreStillToCome) {
  SentLines lines = linesFrom(1, 5);
  lines.refuse(3);               // 3 was lost; 4 and 5 follow it
  EXPECT_EQ(lines.count(), 4U);  // 1 and 2 wait for their oks, 4 and 5 for their refusals
  EXPECT_TRUE(lines.hasStale());
  EXPECT_TRUE(lines.absorbRefusal());
  EXPECT_TRUE(lines.absorbRefusal());
  EXPECT_FALSE(lines.absorbRefusal());
  EXPECT_EQ(lines.acknowledge(), 1U);
  EXPECT_EQ(lines.acknowledge(), 2U);
}

TEST(SentLines, ForgetStaleLinesThatWereDiscardedUnseen) {
  SentLines lines = linesFrom(1, 5);
  lines.refuse(2);
  lines.dropStale();
  EXPECT_EQ(lines.count(), 1U);
  EXPECT_EQ(lines.bytes(), 10U);
}

TEST(SentLines, TakeASecondCopyBeforeTheWantedLineForOneThatIsRefused) {
  SentLines lines;
  lines.add({4, 10, false, true, false});
  lines.add({5, 10, false, true, false});
  lines.refuse(6);
  EXPECT_EQ(lines.count(), 1U);
  EXPECT_EQ(lines.acknowledge(), std::nullopt);
}

}  // namespace
}  // namespace lamina
