// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drive_clock.hpp"

#include "lamina/base/clock.hpp"

namespace lamina {
namespace {

constexpr double kTogether = 0.002;  // s within which two clocks are read at once
constexpr int kLooks = 5;

}  // namespace

DriveInstant presentInstant() {
  if (!ros::Time::isSystemTime()) return {ros::Time::now(), std::nullopt};
  const SteadyClock clock;
  for (int look = 0; look < kLooks; ++look) {
    const double before_s = clock.now();
    const ros::Time now = ros::Time::now();
    const double passed_s = clock.now() - before_s;
    if (passed_s <= kTogether) return {now, before_s + 0.5 * passed_s};
  }
  return {ros::Time::now(), std::nullopt};
}

}  // namespace lamina
