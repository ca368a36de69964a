// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace lamina {

/// Interface through which time is read: a real clock in production, a clock set by hand in tests.
class Clock {
 public:
  virtual ~Clock() = default;
  /// Time [s] since an arbitrary time; never decreases.
  virtual double now() const = 0;
};

/// The monotonic clock of the computer.
class SteadyClock final : public Clock {
 public:
  double now() const override {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
};

}  // namespace lamina
