// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace lamina {

/// Sends orders to another node, one after the other, in a thread of its own: the caller never waits for the
/// answer.
class OrderThread {
 public:
  OrderThread();
  /// Waits for the order under way; later orders are not sent.
  ~OrderThread();
  OrderThread(const OrderThread&) = delete;
  OrderThread& operator=(const OrderThread&) = delete;

  void give(std::function<void()> order);

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> orders_;
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace lamina
