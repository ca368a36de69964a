// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/starvation_watch.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

/// Sends a motion and has it answered after `answer_s`.
void run(StarvationWatch& watch, std::uint64_t line, double seconds, double now, double answer_s) {
  watch.sent(line, seconds, now);
  watch.acknowledged(line, std::nullopt, now + answer_s);
}

TEST(StarvationWatch, SaysNothingOfAMachineThatIsFedInTime) {
  StarvationWatch watch;
  for (int i = 0; i < 100; ++i) run(watch, static_cast<std::uint64_t>(i) + 1, 0.2, 0.1 * i, 0.001);
  EXPECT_EQ(watch.starvation().count, 0U);
}

TEST(StarvationWatch, TellsWhereALineCameTooLateAndByHowMuch) {
  StarvationWatch watch;
  run(watch, 1, 0.5, 0.0, 0.001);  // lasts until 0.501
  run(watch, 2, 0.5, 0.2, 0.001);  // until 1.001
  run(watch, 3, 0.5, 1.3, 0.001);  // 0.3 s too late
  run(watch, 4, 0.5, 1.9, 0.001);  // until 1.801 only: 0.1 s too late
  EXPECT_EQ(watch.starvation().count, 2U);
  EXPECT_NEAR(watch.starvation().longest_s, 0.3, 1e-9);
  EXPECT_EQ(watch.starvation().line, 3U);
}

TEST(StarvationWatch, TakesALateAnswerForAFullPlanner) {
  StarvationWatch watch;
  // Each answer comes when a motion has ended that acceleration makes three times as long as its feed says.
  for (int i = 0; i < 100; ++i) run(watch, static_cast<std::uint64_t>(i) + 1, 0.1, 0.3 * i, 0.29);
  EXPECT_EQ(watch.starvation().count, 0U);
  run(watch, 101, 0.1, 31.0, 0.001);  // eight motions of 0.1 s were in it at 29.99
  EXPECT_EQ(watch.starvation().count, 1U);
  EXPECT_NEAR(watch.starvation().longest_s, 31.001 - 30.79, 1e-9);
}

TEST(StarvationWatch, SeesAHostThatWasHeldUpLongerThanAnyPlannerLasts) {
  StarvationWatch watch;
  for (int i = 0; i < 50; ++i) run(watch, static_cast<std::uint64_t>(i) + 1, 0.1, 0.1 * i, 0.09);
  run(watch, 51, 0.1, 5.0, 10.0);  // 24 motions of 0.1 s last 3.6 s at most
  EXPECT_EQ(watch.starvation().count, 1U);
  EXPECT_NEAR(watch.starvation().longest_s, 15.0 - 4.99 - 3.6, 1e-9);
  watch.sent(52, 0.1, 15.0);
  watch.busy(24.0);
  watch.acknowledged(52, std::nullopt, 25.0);
  EXPECT_EQ(watch.starvation().count, 1U) << "the machine itself was busy";
}

TEST(StarvationWatch, ExpectsNoMotionWhereTheProgramWaitsOrIsPaused) {
  StarvationWatch watch;
  run(watch, 1, 0.1, 0.0, 0.001);
  watch.sentWait(2, 0.002);
  watch.acknowledged(2, std::nullopt, 60.0);
  run(watch, 3, 0.1, 60.0, 0.001);
  watch.standStill();
  run(watch, 4, 0.1, 120.0, 0.001);
  EXPECT_EQ(watch.starvation().count, 0U);
}

TEST(StarvationWatch, BelievesTheFirmwaresReportOfItsPlanner) {
  StarvationWatch watch;
  const auto report = [&watch](std::uint64_t line, int free_blocks, double now) {
    watch.sent(line, 0.1, now - 0.001);
    watch.acknowledged(line, free_blocks, now);
  };
  report(1, 15, 0.001);
  report(2, 9, 1.0);  // by its feed it would have been dry for 0.9 s, but other motions are in it
  EXPECT_EQ(watch.starvation().count, 0U);
  report(3, 14, 2.0);
  EXPECT_EQ(watch.starvation().count, 1U);
  EXPECT_EQ(watch.starvation().line, 3U);
}

TEST(StarvationWatch, ForgetsLinesThatWereNotTaken) {
  StarvationWatch watch;
  watch.sent(1, 0.1, 0.0);
  watch.sent(2, 5.0, 0.0);
  watch.rewound(2);
  watch.acknowledged(1, std::nullopt, 0.001);
  watch.sent(2, 0.1, 0.3);
  watch.acknowledged(2, std::nullopt, 0.301);
  EXPECT_EQ(watch.starvation().count, 1U);
  EXPECT_NEAR(watch.starvation().longest_s, 0.2, 1e-9);
}

}  // namespace
}  // namespace lamina
