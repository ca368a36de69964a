// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/emulated_vacuum.hpp"

#include <cmath>

namespace lamina {

EmulatedVacuum::EmulatedVacuum(const EmulatedSettings& settings)
    : zones_(static_cast<std::size_t>(settings.vacuum_zones)), time_s_(settings.vacuum_time_s) {
  for (Zone& zone : zones_) zone.lowest_kpa = settings.vacuum_kpa;
  if (has(settings.leaking_zone)) zones_[index(settings.leaking_zone)].lowest_kpa = settings.leak_kpa;
}

void EmulatedVacuum::switchOff() {
  for (Zone& zone : zones_) zone.is_open = false;
}

void EmulatedVacuum::elapse(double seconds) {
  const double left = std::exp(-seconds / time_s_);
  for (Zone& zone : zones_) {
    const double goal_kpa = zone.is_open ? zone.lowest_kpa : kAirKpa;
    zone.kpa = goal_kpa + (zone.kpa - goal_kpa) * left;
  }
}

}  // namespace lamina
