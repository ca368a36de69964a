// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/emulated_heaters.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lamina {

double EmulatedHeater::goal() const { return std::max(std::min(target_c_, limit_c_), ambient_c_); }

void EmulatedHeater::elapse(double seconds) {
  const double most = rate_c_s_ * seconds;
  actual_c_ += std::clamp(goal() - actual_c_, -most, most);
}

double EmulatedHeater::timeToHeat() const { return std::max(goal() - actual_c_, 0.0) / rate_c_s_; }

double EmulatedHeater::timeToReach() const { return std::abs(goal() - actual_c_) / rate_c_s_; }

void EmulatedHeaters::elapse(double seconds) {
  nozzle.elapse(seconds);
  bed.elapse(seconds);
  if (dryer) dryer->elapse(seconds);
}

void EmulatedHeaters::switchOff() {
  nozzle.setTarget(0.0);
  bed.setTarget(0.0);
  if (dryer) dryer->setTarget(0.0);
}

std::string EmulatedHeaters::report() const {
  char text[96];
  std::snprintf(text, sizeof text, "T:%.2f /%.2f B:%.2f /%.2f", nozzle.actual(), nozzle.target(),
                bed.actual(), bed.target());
  if (!dryer) return std::string(text) + " @:0 B@:0";
  char chamber[48];
  std::snprintf(chamber, sizeof chamber, " C:%.2f /%.2f @:0 B@:0 C@:0", dryer->actual(), dryer->target());
  return std::string(text) + chamber;
}

}  // namespace lamina
