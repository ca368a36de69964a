// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/control/loop_settings.hpp"

namespace lamina {

/// How a sensor that trails the nozzle trims the amount within a layer.
struct TrimSettings {
  double gain_per_mm = 0.0;  ///< change of the amount per relative error and way
  double behind_mm = 0.0;    ///< the sensor, behind where trims act
  double step_mm = 0.5;      ///< way from call to call
  double growth = 1.0;       ///< learnt, over commanded growth; 0 predicts nothing
  double range = 0.2;        ///< of the trim, either way
};

/// The trim that the loop's settings ask for; none if they ask for none.
/// @param growth  learnt, over commanded growth
std::optional<TrimSettings> trimOf(const LoopSettings& settings, double step_mm, double growth);

/// The slow part of what a feeder drifts within a layer, taken off by a sensor behind the nozzle. What the
/// trims under way between nozzle and sensor will show is predicted, and only what differs from it is fed
/// back [Smith1957]: so the distance costs no stability as long as growth is known.
class TrailingTrim {
 public:
  /// @throws InvalidInput if step or distance are not positive, or the distance is beyond 10^5 steps
  explicit TrailingTrim(const TrimSettings& settings);

  /// The nozzle goes on by a step.
  /// @param relative_error  of growth under the sensor: positive is too much; none where it sees nothing, and
  ///   what is not finite is none
  /// @return the trim to add to the amount from here on
  double advance(std::optional<double> relative_error);

  double trim() const { return trim_; }

 private:
  TrimSettings settings_;
  std::vector<double> under_way_;  ///< trims, the oldest at `next_`
  std::size_t next_ = 0;
  double trim_ = 0.0;
};

}  // namespace lamina
