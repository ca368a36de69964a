// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/toolpath/motion_planner.hpp"

namespace lamina {

/// What is to leave the nozzle along one run, over the time from its start: linear between instants, at which
/// it may jump; nothing before and after.
class DesiredFlow {
 public:
  /// A motion that lays a bead of that section [mm²], next to those added before.
  void add(const SpeedProfile& profile, double section_mm2);

  double duration() const { return stretches_.empty() ? 0.0 : stretches_.back().end_s; }
  /// Before a jump at that very instant [mm³/s].
  double flowBefore(double time_s) const;
  /// Up to that time [mm³].
  double volumeUntil(double time_s) const;
  /// Where its slope may change, strictly between two times, ascending.
  std::vector<double> changesBetween(double from_s, double to_s) const;

 private:
  struct Stretch {
    double start_s;
    double end_s;
    double from_mm3_s;
    double to_mm3_s;
    double volume_before_mm3;

    double flowAt(double time_s) const;
    double volume(double until_s) const;
  };

  void addStretch(double duration_s, double from_mm3_s, double to_mm3_s);
  /// The stretch that ends at or after that time, if there is one.
  std::vector<Stretch>::const_iterator stretchAt(double time_s) const;

  std::vector<Stretch> stretches_;
};

}  // namespace lamina
