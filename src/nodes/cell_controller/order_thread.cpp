// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "order_thread.hpp"

#include <utility>

namespace lamina {

OrderThread::OrderThread() : thread_([this] { run(); }) {}

OrderThread::~OrderThread() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void OrderThread::give(std::function<void()> order) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    orders_.push_back(std::move(order));
  }
  changed_.notify_all();
}

void OrderThread::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_ending_ || !orders_.empty(); });
    if (is_ending_) return;
    const auto order = std::move(orders_.front());
    orders_.pop_front();
    lock.unlock();
    order();
    lock.lock();
  }
}

}  // namespace lamina
