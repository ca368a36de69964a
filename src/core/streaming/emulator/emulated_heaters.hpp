// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "lamina/streaming/emulator/emulated_settings.hpp"

namespace lamina {

/// A heater that heats and cools at a constant rate, in machine time.
class EmulatedHeater {
 public:
  /// @param limit_c  highest temperature that it reaches
  EmulatedHeater(double ambient_c, double rate_c_s, double limit_c)
      : ambient_c_(ambient_c), rate_c_s_(rate_c_s), limit_c_(limit_c), actual_c_(ambient_c) {}

  void setTarget(double target_c) { target_c_ = target_c; }
  void elapse(double seconds);
  double actual() const { return actual_c_; }
  double target() const { return target_c_; }
  /// Heating time until the lower of target and limit is reached; 0 if the heater is at least as warm.
  double timeToHeat() const;
  /// Time until the target is reached by heating or cooling.
  double timeToReach() const;

 private:
  double goal() const;

  double ambient_c_;
  double rate_c_s_;
  double limit_c_;
  double actual_c_;
  double target_c_ = 0.0;  ///< 0 is off
};

struct EmulatedHeaters {
  explicit EmulatedHeaters(const EmulatedSettings& settings)
      : nozzle(settings.ambient_c, settings.nozzle_heating_c_s, kNoLimit),
        bed(settings.ambient_c, settings.bed_heating_c_s, settings.bed_limit_c) {
    if (settings.has_dryer) dryer.emplace(settings.ambient_c, settings.dryer_heating_c_s, kNoLimit);
  }

  void elapse(double seconds);
  void switchOff();
  /// Temperature report in Marlin's format, with a dryer as the heated chamber C: "T:20.00 /0.00 B:20.00
  /// /0.00 @:0 B@:0".
  std::string report() const;

  EmulatedHeater nozzle;
  EmulatedHeater bed;
  std::optional<EmulatedHeater> dryer;

 private:
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
};

}  // namespace lamina
