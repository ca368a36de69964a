// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/clock.hpp"

namespace lamina {

/// Time since the last lap [s].
class Laps {
 public:
  double lap() {
    const double now = clock_.now();
    const double passed = now - last_;
    last_ = now;
    return passed;
  }

 private:
  SteadyClock clock_;
  double last_ = clock_.now();
};

}  // namespace lamina
