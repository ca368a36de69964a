// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <future>
#include <string>
#include <thread>

namespace lamina {

/// Calls a function periodically, timed by the monotonic clock, in a thread of its own. If the user has the
/// rights to it, the thread gets real-time priority and the memory of the process is locked.
class PeriodicThread {
 public:
  /// @param cycle  is called with the time at which the call was due, by `SteadyClock` [s]; if cycles were
  ///   missed, with the due time of the first missed cycle
  /// @throws DeviceError if the system has no timer left
  PeriodicThread(double rate_hz, std::function<void(double due_s)> cycle);
  /// Waits for a call under way and ends the thread: no call is made afterwards.
  ~PeriodicThread();
  PeriodicThread(const PeriodicThread&) = delete;
  PeriodicThread& operator=(const PeriodicThread&) = delete;

  /// Whether the thread got real-time priority and locked memory, in words: "in real time, memory locked".
  /// Waits until the thread runs.
  std::string rights();

 private:
  void run();

  double period_s_;
  std::function<void(double)> cycle_;
  int timer_;
  int end_;
  bool is_memory_locked_ = false;
  std::promise<bool> is_real_time_;
  std::future<bool> answer_ = is_real_time_.get_future();
  std::thread thread_;
};

}  // namespace lamina
