// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/toolpath/motion_planner.hpp"

namespace lamina {

/// The flow that is to leave the nozzle along one run, over the time from its start. It is piecewise linear,
/// may jump between pieces, and is 0 before and after the run.
class DesiredFlow {
 public:
  /// Appends a motion that lays a bead of that section [mm²].
  void add(const SpeedProfile& profile, double section_mm2);

  double duration() const { return stretches_.empty() ? 0.0 : stretches_.back().end_s; }
  /// The flow at a time [mm³/s]; that before a jump at it.
  double flowBefore(double time_s) const;
  /// The volume up to a time [mm³].
  double volumeUntil(double time_s) const;
  /// Times strictly between two times at which the slope may change, ascending.
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
