// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/time_left.hpp"

#include <algorithm>

namespace lamina {
namespace {

constexpr double kLeastSeen = 0.005;

}  // namespace

void TimeLeft::begin(double fraction, double running_s) {
  fraction_ = fraction;
  running_s_ = running_s;
}

std::optional<double> TimeLeft::at(double fraction, double running_s) const {
  const double seen = fraction - fraction_;
  if (seen < kLeastSeen) return std::nullopt;
  return std::max(0.0, (running_s - running_s_) * (1.0 - fraction) / seen);
}

}  // namespace lamina
