// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/height_controller/print_hold.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace lamina {
namespace {

/// An executor that answers when it is told to.
struct SlowExecutor {
  std::promise<PrintHold::Answer> answer;
  std::shared_future<PrintHold::Answer> future = answer.get_future().share();
  std::atomic<int> asked{0};

  /// The first request waits for the answer; those that follow are granted at once.
  PrintHold::Answer operator()() {
    if (++asked == 1) return future.get();
    return {true, "the print is held"};
  }
};

std::string lateAnswer(PrintHold& hold) {
  using namespace std::chrono_literals;
  std::optional<std::string> late = hold.takeLate();
  for (int i = 0; i < 10000 && !late; ++i) {
    std::this_thread::sleep_for(1ms);  // until the thread that asked has ended
    late = hold.takeLate();
  }
  return late.value_or("");
}

TEST(PrintHold, PassesOnAnAnswerThatComesLate) {
  SlowExecutor executor;
  PrintHold hold([&executor] { return executor(); });
  EXPECT_FALSE(hold.takeLate()) << "nothing was asked";
  EXPECT_EQ(hold.hold(), "the print has not answered to pause within 1 s");
  EXPECT_FALSE(hold.takeLate());
  executor.answer.set_value({false, "the print is not held: it has not begun"});
  EXPECT_EQ(lateAnswer(hold), "the print is not held: it has not begun");
  EXPECT_FALSE(hold.takeLate()) << "it was passed on";
  EXPECT_EQ(executor.asked, 1);
}

TEST(PrintHold, AsksAgainWhileTheUnitIsOnItsWayToGoOn) {
  SlowExecutor executor;
  PrintHold hold([&executor] { return executor(); });
  EXPECT_EQ(hold.hold(), "the print has not answered to pause within 1 s");
  executor.answer.set_value({false, "the unit is suspended", true});
  EXPECT_EQ(lateAnswer(hold), "the unit is suspended; it is asked until it takes it");
  EXPECT_EQ(lateAnswer(hold), "the print is held");
  EXPECT_EQ(executor.asked, 2);
}

TEST(PrintHold, AsksNothingOnceThePrintIsOver) {
  SlowExecutor executor;
  PrintHold hold([&executor] { return executor(); });
  EXPECT_EQ(hold.hold(), "the print has not answered to pause within 1 s");
  hold.release();
  executor.answer.set_value({false, "the unit is suspended", true});
  EXPECT_EQ(lateAnswer(hold), "the unit is suspended");
  EXPECT_FALSE(hold.takeLate());
  EXPECT_EQ(executor.asked, 1);
}

TEST(PrintHold, AsksAgainForAHoldThatWasAskedForMeanwhile) {
  SlowExecutor executor;
  PrintHold hold([&executor] { return executor(); });
  hold.hold();
  EXPECT_EQ(hold.hold(), "the print was asked to pause before and has not answered");
  executor.answer.set_value({false, "the print is not held: it has not begun"});
  EXPECT_EQ(lateAnswer(hold), "the print is not held: it has not begun; asked again: the print is held");
  EXPECT_EQ(executor.asked, 2);
}

}  // namespace
}  // namespace lamina
