// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/streaming/emulated_settings.hpp"

namespace lamina {

/// Heats and cools at a constant rate in machine time.
class EmulatedHeater {
 public:
  EmulatedHeater(double ambient_c, double rate_c_s)
      : ambient_c_(ambient_c), rate_c_s_(rate_c_s), actual_c_(ambient_c) {}

  void setTarget(double target_c) { target_c_ = target_c; }
  void elapse(double seconds);
  double actual() const { return actual_c_; }
  double target() const { return target_c_; }
  /// Time until the target is reached by heating; 0 if it is warm enough.
  double timeToHeat() const;
  /// Time until the target is reached by heating or cooling.
  double timeToReach() const;

 private:
  double goal() const;

  double ambient_c_;
  double rate_c_s_;
  double actual_c_;
  double target_c_ = 0.0;  ///< 0 is off
};

struct EmulatedHeaters {
  explicit EmulatedHeaters(const EmulatedSettings& settings)
      : nozzle(settings.ambient_c, settings.nozzle_heating_c_s),
        bed(settings.ambient_c, settings.bed_heating_c_s) {}

  void elapse(double seconds);
  /// "T:20.00 /0.00 B:20.00 /0.00 @:0 B@:0", as Marlin reports.
  std::string report() const;

  EmulatedHeater nozzle;
  EmulatedHeater bed;
};

}  // namespace lamina
