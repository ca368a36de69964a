// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <functional>
#include <limits>
#include <utility>

#include "lamina/base/clock.hpp"

namespace lamina {

/// A timer for a deadline that nearly every event postpones. A later deadline does not move the timer: it
/// expires early and is then set again, which costs less. So the callback must tolerate early calls.
class DeadlineTimer {
 public:
  DeadlineTimer(boost::asio::io_context& context, const Clock& clock, std::function<void()> went_off)
      : clock_(clock), went_off_(std::move(went_off)), timer_(context) {}

  /// @param deadline  time of the clock [s]; infinite for never
  void set(double deadline) {
    if (deadline >= set_for_) return;
    set_for_ = deadline;
    const std::chrono::duration<double> wait(std::max(deadline - clock_.now(), 0.0));
    timer_.expires_after(std::chrono::duration_cast<std::chrono::steady_clock::duration>(wait));
    timer_.async_wait([this](const boost::system::error_code& error) {
      if (error) return;
      set_for_ = std::numeric_limits<double>::infinity();
      went_off_();
    });
  }
  void cancel() {
    timer_.cancel();
    set_for_ = std::numeric_limits<double>::infinity();
  }

 private:
  const Clock& clock_;
  std::function<void()> went_off_;
  boost::asio::steady_timer timer_;
  double set_for_ = std::numeric_limits<double>::infinity();
};

}  // namespace lamina
