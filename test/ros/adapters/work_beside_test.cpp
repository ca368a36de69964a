// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/trajectory_driver/work_beside.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

TEST(WorkBeside, GoesOnWhileItsOwnerDoes) {
  std::promise<int> awaited;
  WorkBeside<int> work([&](Progress&) { return awaited.get_future().get() + 1; });
  EXPECT_FALSE(work.isDone());
  awaited.set_value(41);
  EXPECT_EQ(work.take(), 42);
}

TEST(WorkBeside, ThrowsWhatTheWorkThrew) {
  WorkBeside<int> work([](Progress&) -> int { throw Unreachable("layer 3 is out of reach"); });
  EXPECT_THROW(work.take(), Unreachable);
}

TEST(WorkBeside, IsGivenUpWhenItsOwnerEnds) {
  std::atomic<bool> has_ended{false};
  {
    const WorkBeside<int> work([&](Progress& progress) {
      while (!progress.isCancelled()) std::this_thread::yield();
      has_ended = true;
      return 0;
    });
    EXPECT_FALSE(has_ended);
  }
  EXPECT_TRUE(has_ended);
}

}  // namespace
}  // namespace lamina
