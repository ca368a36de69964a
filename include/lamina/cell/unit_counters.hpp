// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "lamina/cell/packml_model.hpp"

namespace lamina {

/// Counters of a unit since they were reset (PackML's Admin tags). A value that is kept in the journal and
/// given back at the next start.
struct UnitCounters {
  using PerState = std::array<double, 17>;  ///< [s], by state number - 1
  std::map<int, PerState> times_s;          ///< by mode number
  std::uint64_t parts = 0;                  ///< printed
  std::uint64_t defective = 0;              ///< of those
  double material_mm3 = 0.0;
};

/// The counters after that much time in a mode and state.
UnitCounters counted(UnitCounters counters, int mode, UnitState state, double duration_s);

/// [s] in a mode, in one of its states, and in all.
double timeIn(const UnitCounters& counters, int mode);
double timeIn(const UnitCounters& counters, int mode, UnitState state);
double totalTime(const UnitCounters& counters);

/// A counter as the standard's 32-bit tags hold it: whole, from 0 again after 2147483647.
std::uint32_t rolledOver(double count);

/// Overall equipment effectiveness and its three factors, each 0 to 1; 0 where nothing was to be done.
/// Availability: Execute of all time in Production. Performance: planned of real time in Execute. Quality:
/// good of all parts. Source: ISO 22400-2.
struct Effectiveness {
  double availability = 0.0;
  double performance = 0.0;
  double quality = 0.0;
  double overall() const { return availability * performance * quality; }
};
Effectiveness effectiveness(const UnitCounters& counters, double planned_execute_s);

}  // namespace lamina
