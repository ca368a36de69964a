// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "lamina/web/cell_desk.hpp"

namespace lamina {

/// Calls services of other nodes one after the other in a thread of its own, and waits for each answer for a
/// bounded time. An order that was not begun in that time is never given.
class ServiceLane {
 public:
  ServiceLane();
  /// Waits for the call under way.
  ~ServiceLane();
  ServiceLane(const ServiceLane&) = delete;
  ServiceLane& operator=(const ServiceLane&) = delete;

  /// @param node  that is asked, for the answer if it gives none
  DeskAnswer ask(const std::string& node, double patience_s, std::function<DeskAnswer()> call);

 private:
  struct Order;
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::shared_ptr<Order>> orders_;
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace lamina
