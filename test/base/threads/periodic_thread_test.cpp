// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/threads/periodic_thread.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "lamina/base/clock.hpp"

namespace lamina {
namespace {

TEST(PeriodicThread, CallsAtItsRateAndReportsWhenACallWasDue) {
  const SteadyClock clock;
  const double begin_s = clock.now();
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<double> due;
  std::vector<double> called;
  {
    PeriodicThread thread(250.0, [&](double due_s) {
      const std::lock_guard<std::mutex> lock(mutex);
      due.push_back(due_s);
      called.push_back(clock.now());
      changed.notify_all();
    });
    EXPECT_NE(thread.rights().find("real time"), std::string::npos);
    std::unique_lock<std::mutex> lock(mutex);
    changed.wait(lock, [&] { return due.size() >= 50; });
  }
  for (std::size_t i = 0; i < due.size(); ++i) {
    EXPECT_GE(called[i], due[i]);
    const double periods = (due[i] - due[0]) * 250.0;
    EXPECT_NEAR(periods, std::round(periods), 1e-6);
    EXPECT_GE(due[i], begin_s + 0.004);
  }
}

TEST(PeriodicThread, EndsBeforeItsFirstCall) {
  bool was_called = false;
  {
    const PeriodicThread thread(0.001, [&](double) { was_called = true; });
  }
  EXPECT_FALSE(was_called);
}

}  // namespace
}  // namespace lamina
