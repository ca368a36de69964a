// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "service_lane.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace lamina {

struct ServiceLane::Order {
  std::function<DeskAnswer()> call;
  std::optional<DeskAnswer> answer;
  bool is_under_way = false;
};

ServiceLane::ServiceLane() : thread_([this] { run(); }) {}

ServiceLane::~ServiceLane() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

DeskAnswer ServiceLane::ask(const std::string& node, double patience_s, std::function<DeskAnswer()> call) {
  const auto order = std::make_shared<Order>();
  order->call = std::move(call);
  std::unique_lock<std::mutex> lock(mutex_);
  orders_.push_back(order);
  changed_.notify_all();
  changed_.wait_for(lock, std::chrono::duration<double>(patience_s),
                    [&] { return order->answer || is_ending_; });
  if (order->answer) return *order->answer;
  orders_.erase(std::remove(orders_.begin(), orders_.end(), order), orders_.end());
  DeskAnswer silent;
  silent.outcome = DeskAnswer::Outcome::Silent;
  silent.message = node + " has not answered; " +
                   (order->is_under_way ? "it may still do what was asked" : "nothing was asked of it");
  return silent;
}

void ServiceLane::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_ending_ || !orders_.empty(); });
    if (is_ending_) return;
    const auto order = std::move(orders_.front());
    orders_.pop_front();
    order->is_under_way = true;
    lock.unlock();
    const DeskAnswer answer = order->call();
    lock.lock();
    order->answer = answer;
    changed_.notify_all();
  }
}

}  // namespace lamina
