// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/control/loop_settings.hpp"

namespace lamina {

/// Settings of a trim of the amount within a layer, by a sensor behind the nozzle.
struct TrimSettings {
  double gain_per_mm = 0.0;  ///< change of the amount per relative error and distance
  double behind_mm = 0.0;    ///< distance of the sensor behind the place where trims act
  double step_mm = 0.5;      ///< distance between calls
  double growth = 1.0;       ///< gain learnt, actual over commanded growth; 0: no prediction
  double range = 0.2;        ///< greatest trim, either way
};

/// The trim that the settings of the loop ask for; none if they ask for none.
/// @param growth  as in `TrimSettings`
std::optional<TrimSettings> trimOf(const LoopSettings& settings, double step_mm, double growth);

/// Trims the amount within a layer, so as to remove slow drift of a feeder. A Smith predictor [Smith1957]
/// states what trims between nozzle and sensor will change, and only the rest of the error is fed back: the
/// distance of the sensor costs no stability as long as the gain is known.
class TrailingTrim {
 public:
  /// @throws InvalidInput if step or distance are not positive, or the distance is beyond 10^5 steps
  explicit TrailingTrim(const TrimSettings& settings);

  /// Moves the nozzle on by a step.
  /// @param relative_error  of growth under the sensor, positive if too much; none, or not finite, where the
  ///   sensor sees nothing
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
