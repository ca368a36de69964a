// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/unit_counters.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lamina {
namespace {

std::size_t indexOf(UnitState state) { return static_cast<std::size_t>(state) - 1; }

std::string timeName(int mode, std::size_t state) {
  return "mode." + std::to_string(mode) + ".state." + std::to_string(state);
}

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

std::map<std::string, double> namedCounters(const UnitCounters& counters) {
  std::map<std::string, double> named = {{"parts", static_cast<double>(counters.parts)},
                                         {"defective", static_cast<double>(counters.defective)},
                                         {"material_mm3", counters.material_mm3}};
  for (const auto& [mode, times] : counters.times_s)
    for (std::size_t i = 0; i < times.size(); ++i) named[timeName(mode, i + 1)] = times.at(i);
  return named;
}

UnitCounters countersOf(const std::map<std::string, double>& named, const std::vector<UnitMode>& modes) {
  const auto value = [&named](const std::string& name) {
    const auto found = named.find(name);
    return found == named.end() ? 0.0 : found->second;
  };
  UnitCounters counters;
  counters.parts = static_cast<std::uint64_t>(value("parts"));
  counters.defective = static_cast<std::uint64_t>(value("defective"));
  counters.material_mm3 = value("material_mm3");
  for (const UnitMode& mode : modes)
    for (const UnitState state : unitStates()) {
      const double time_s = value(timeName(mode.number, static_cast<std::size_t>(state)));
      if (time_s > 0.0) counters = counted(std::move(counters), mode.number, state, time_s);
    }
  return counters;
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
