// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lamina/cell/packml_model.hpp"

namespace lamina {

/// Counters of a unit since they were last reset (PackML's Admin tags). They are stored in the journal, and
/// passed to the unit at the next start.
struct UnitCounters {
  using PerState = std::array<double, 17>;  ///< [s], by state number - 1
  std::map<int, PerState> times_s;          ///< time in each state, by mode number
  std::uint64_t parts = 0;                  ///< number of parts printed
  std::uint64_t defective = 0;              ///< number of defective parts
  double material_mm3 = 0.0;                ///< volume deposited
};

/// The counters with a duration added to the time in a mode and state.
UnitCounters counted(UnitCounters counters, int mode, UnitState state, double duration_s);

/// Time [s] in a mode; in one state of a mode; and in all modes.
double timeIn(const UnitCounters& counters, int mode);
double timeIn(const UnitCounters& counters, int mode, UnitState state);
double totalTime(const UnitCounters& counters);

/// The counters by the names that they have in the journal.
std::map<std::string, double> namedCounters(const UnitCounters& counters);
/// The counters of the journal; 0 for counters that it lacks. Times in modes that are not given are left out.
UnitCounters countersOf(const std::map<std::string, double>& named, const std::vector<UnitMode>& modes);

/// A counter as in the standard's 32-bit tags: rounded down, and beginning at 0 again after 2147483647.
std::uint32_t rolledOver(double count);

/// Overall equipment effectiveness and its three factors, each 0 to 1; 0 where the divisor is 0.
/// Availability: time in Execute over all time in Production. Performance: planned over actual time in
/// Execute. Quality: good parts over all parts. Source: ISO 22400-2.
struct Effectiveness {
  double availability = 0.0;
  double performance = 0.0;
  double quality = 0.0;
  double overall() const { return availability * performance * quality; }
};
/// The effectiveness by the counters.
/// @param planned_execute_s  planned time in Execute of the jobs that were done
Effectiveness effectiveness(const UnitCounters& counters, double planned_execute_s);

}  // namespace lamina
