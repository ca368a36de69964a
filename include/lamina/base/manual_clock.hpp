// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/clock.hpp"

namespace lamina {

/// A clock that stands still until it is set, for simulations and tests.
class ManualClock final : public Clock {
 public:
  double now() const override { return now_s_; }
  /// Sets the clock to a later time; an earlier one has no effect.
  void moveTo(double time_s) { now_s_ = time_s > now_s_ ? time_s : now_s_; }

 private:
  double now_s_ = 0.0;
};

}  // namespace lamina
