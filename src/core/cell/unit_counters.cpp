// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/unit_counters.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lamina {
namespace {

std::size_t indexOf(UnitState state) { return static_cast<std::size_t>(state) - 1; }

double ratio(double part, double whole) { return whole > 0.0 ? std::min(1.0, part / whole) : 0.0; }

}  // namespace

UnitCounters counted(UnitCounters counters, int mode, UnitState state, double duration_s) {
  counters.times_s[mode].at(indexOf(state)) += duration_s;
  return counters;
}

double timeIn(const UnitCounters& counters, int mode) {
  const auto found = counters.times_s.find(mode);
  if (found == counters.times_s.end()) return 0.0;
  return std::accumulate(found->second.begin(), found->second.end(), 0.0);
}

double timeIn(const UnitCounters& counters, int mode, UnitState state) {
  const auto found = counters.times_s.find(mode);
  return found == counters.times_s.end() ? 0.0 : found->second.at(indexOf(state));
}

double totalTime(const UnitCounters& counters) {
  double total = 0.0;
  for (const auto& [mode, times] : counters.times_s) total += timeIn(counters, mode);
  return total;
}

std::uint32_t rolledOver(double count) {
  constexpr double kRange = 2147483648.0;
  return static_cast<std::uint32_t>(std::fmod(std::max(0.0, std::floor(count)), kRange));
}

Effectiveness effectiveness(const UnitCounters& counters, double planned_execute_s) {
  const double execute = timeIn(counters, kProduction, UnitState::Execute);
  const auto good = static_cast<double>(counters.parts - std::min(counters.parts, counters.defective));
  return {ratio(execute, timeIn(counters, kProduction)), ratio(planned_execute_s, execute),
          ratio(good, static_cast<double>(counters.parts))};
}

}  // namespace lamina
