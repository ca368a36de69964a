// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/line_feed.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

/// "L1", "L2", … up to `count`.
LineFeed feedOf(int count) {
  return LineFeed(
      [count, given = 0]() mutable -> std::optional<ProgramLine> {
        if (given == count) return std::nullopt;
        ++given;
        return ProgramLine{"L" + std::to_string(given), given};
      },
      1);
}

TEST(LineFeed, GivesLinesInOrderAndNothingAfterTheLast) {
  LineFeed feed = feedOf(2);
  EXPECT_EQ(feed.next(), 1U);
  EXPECT_EQ(feed.peek()->command, "L1");
  EXPECT_EQ(feed.end(), 1U);
  feed.advance();
  EXPECT_EQ(feed.end(), 2U);
  EXPECT_EQ(feed.peek()->command, "L2");
  feed.advance();
  EXPECT_EQ(feed.peek(), nullptr);
  EXPECT_EQ(feed.end(), 3U);
}

TEST(LineFeed, GoesBackToAnyLineItRemembersAndForwardAgain) {
  LineFeed feed = feedOf(5);
  for (int i = 0; i < 4; ++i) {
    feed.peek();
    feed.advance();
  }
  ASSERT_TRUE(feed.rewind(2));
  EXPECT_EQ(feed.peek()->command, "L2");
  EXPECT_EQ(feed.end(), 5U);
  EXPECT_EQ(feed.layerOf(3), 3);
  ASSERT_TRUE(feed.rewind(5));
  EXPECT_EQ(feed.peek()->command, "L5");
}

TEST(LineFeed, RefusesLinesNeverSentOrForgotten) {
  LineFeed feed = feedOf(5000);
  EXPECT_FALSE(feed.rewind(2));
  EXPECT_FALSE(feed.rewind(0));
  for (int i = 0; i < 5000; ++i) {
    feed.peek();
    feed.advance();
  }
  EXPECT_FALSE(feed.rewind(1));
  EXPECT_TRUE(feed.rewind(4990));
  EXPECT_FALSE(feed.rewind(5002));
}

}  // namespace
}  // namespace lamina
