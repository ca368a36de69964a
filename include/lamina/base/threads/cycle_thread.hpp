// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <future>
#include <string>
#include <thread>

namespace lamina {

/// Calls something at a rate, by the monotonic clock, in a thread of its own: in real time and in locked
/// memory where the user may.
class CycleThread {
 public:
  /// @param cycle  is given when the call was due, by `SteadyClock` [s]; where cycles were missed, when the
  /// first
  ///   of them was
  /// @throws DeviceError if the system has no timer left
  CycleThread(double rate_hz, std::function<void(double due_s)> cycle);
  /// No call is made from then on.
  ~CycleThread();
  CycleThread(const CycleThread&) = delete;
  CycleThread& operator=(const CycleThread&) = delete;

  /// What the thread has been given, in words: "in real time, memory locked". Waits until it runs.
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
