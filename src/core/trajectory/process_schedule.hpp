// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "lamina/toolpath/process_signals.hpp"
#include "lamina/trajectory/process_events.hpp"
#include "lamina/trajectory/process_settings.hpp"
#include "trajectory/timeline.hpp"

namespace lamina {

/// Times along a timeline at which process outputs are on.
class ProcessSchedule {
 public:
  /// Treatment of a bead for which lead and lag times leave no time. Laser or wire are not switched on for
  /// it. For a whole bead this is an error of the settings; for the rest of a bead cut by a pause it is
  /// allowed.
  enum class Beads : std::uint8_t { Whole, Cut };

  ProcessSchedule() = default;
  /// @throws InvalidInput if leads and lags leave no time for a whole bead
  ProcessSchedule(const Timeline& timeline, double averaging_s, const ProcessSettings& settings, Beads beads);

  /// Switches everything off from this time on.
  void makeSafeFrom(double time_s) { safe_from_s_ = std::min(safe_from_s_, time_s); }

  /// @param motion  flow and levels of the motion at that time; levels of switched-off outputs are set to 0
  ProcessSignals signalsAt(double time_s, const ProcessSignals& motion) const;
  /// In order of time; at one instant in the order laser, wire, powder, gas.
  std::vector<ProcessEvent> events() const;

 private:
  struct Interval {
    double from_s = 0.0;
    double to_s = 0.0;
  };
  using Intervals = std::vector<Interval>;
  struct Leads {
    double on_s = 0.0;
    double off_s = 0.0;
  };
  static Intervals beadsOf(const Timeline& timeline, double averaging_s);
  static Intervals runsOf(const Timeline& timeline, double averaging_s);
  static Intervals shifted(const Intervals& beads, const Leads& leads, const char* what, Beads kind);
  static bool isIn(const Intervals& intervals, double time_s);

  ProcessSettings settings_;
  Intervals laser_;
  Intervals wire_;
  Intervals carriers_;  ///< gas, and powder if that is the process
  double safe_from_s_ = std::numeric_limits<double>::infinity();
};

}  // namespace lamina
