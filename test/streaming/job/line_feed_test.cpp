// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/line_feed.hpp"

#include <gtest/gtest.h>

#include <future>

#include "lamina/base/clock.hpp"

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

/// A disk that stops to answer after some lines, until it is let go on.
class StuckDisk {
 public:
  explicit StuckDisk(int lines) : lines_(lines) {}
  ~StuckDisk() { goes_on_.set_value(); }

  LineFeed::Source lines() {
    return [left = lines_, wait = goes_on_.get_future().share()]() mutable -> std::optional<ProgramLine> {
      if (left-- > 0) return ProgramLine{"G4 P1", -1};
      wait.wait();
      return std::nullopt;
    };
  }

 private:
  int lines_;
  std::promise<void> goes_on_;
};

TEST(ReadAhead, GivesAllLinesAndThenNone) {
  LineFeed::Source source = readAhead(
      [left = 1000]() mutable -> std::optional<ProgramLine> {
        if (left == 0) return std::nullopt;
        return ProgramLine{"L" + std::to_string(--left), -1};
      },
      [] { return false; }, 60.0);
  for (int left = 999; left >= 0; --left) ASSERT_EQ(source()->command, "L" + std::to_string(left));
  EXPECT_FALSE(source());
  EXPECT_FALSE(source());
}

TEST(ReadAhead, EndsWhereWhatIsReadWasChanged) {
  LineFeed::Source source = readAhead([] { return ProgramLine{"G4 P1", -1}; }, [] { return true; }, 60.0);
  EXPECT_FALSE(source());
}

/// Of a network folder, one question of many may fail.
TEST(ReadAhead, EndsWhereOneLookOfManySaysThatWhatIsReadWasChanged) {
  for (const int changed_at : {1, 2, 3}) {
    LineFeed::Source source = readAhead(
        [given = 0]() mutable -> std::optional<ProgramLine> {
          if (given == 300) return std::nullopt;
          return ProgramLine{"L" + std::to_string(++given), -1};
        },
        [changed_at, looks = 0]() mutable { return ++looks == changed_at; }, 60.0);
    int expected = 1;
    while (const auto line = source()) {
      ASSERT_EQ(line->command, "L" + std::to_string(expected++)) << "look " << changed_at;
    }
    EXPECT_EQ(expected, 128 * (changed_at - 1) + 1) << "look " << changed_at;
  }
}

TEST(ReadAhead, NeitherWaitsNorEndsWithADiskThatDoesNotAnswer) {
  StuckDisk disk(200);
  const SteadyClock clock;
  const double begin_s = clock.now();
  {
    LineFeed::Source source = readAhead(
        disk.lines(), [] { return false; }, 0.05);
    // The first 128 lines are read as one.
    for (int i = 0; i < 128; ++i) ASSERT_TRUE(source()) << i;
    EXPECT_FALSE(source());
    EXPECT_FALSE(source()) << "for good";
  }
  EXPECT_LT(clock.now() - begin_s, 30.0) << "it is not waited for";
}

}  // namespace
}  // namespace lamina
