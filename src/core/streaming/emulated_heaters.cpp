// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulated_heaters.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lamina {

double EmulatedHeater::goal() const { return std::max(target_c_, ambient_c_); }

void EmulatedHeater::elapse(double seconds) {
  const double most = rate_c_s_ * seconds;
  actual_c_ += std::clamp(goal() - actual_c_, -most, most);
}

double EmulatedHeater::timeToHeat() const { return std::max(target_c_ - actual_c_, 0.0) / rate_c_s_; }

double EmulatedHeater::timeToReach() const { return std::abs(goal() - actual_c_) / rate_c_s_; }

void EmulatedHeaters::elapse(double seconds) {
  nozzle.elapse(seconds);
  bed.elapse(seconds);
}

std::string EmulatedHeaters::report() const {
  char text[96];
  std::snprintf(text, sizeof text, "T:%.2f /%.2f B:%.2f /%.2f @:0 B@:0", nozzle.actual(), nozzle.target(),
                bed.actual(), bed.target());
  return text;
}

}  // namespace lamina
