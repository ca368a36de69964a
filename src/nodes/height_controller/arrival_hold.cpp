// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "arrival_hold.hpp"

#include <limits>

namespace lamina {

void ArrivalHold::add(double now_s, std::function<void()> use) { kept_.emplace_back(now_s, std::move(use)); }

void ArrivalHold::release(double now_s) {
  while (!kept_.empty() && kept_.front().first + hold_s_ <= now_s) {
    kept_.front().second();
    kept_.pop_front();
  }
}

void ArrivalHold::releaseAll() { release(std::numeric_limits<double>::infinity()); }

}  // namespace lamina
