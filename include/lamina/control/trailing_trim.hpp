// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/control/loop_settings.hpp"

namespace lamina {

/// Settings of a trim: a correction of the amount within a layer, by a sensor behind the nozzle.
struct TrimSettings {
  double gain_per_mm = 0.0;  ///< change of the amount per relative error and distance
  double behind_mm = 0.0;    ///< distance of the sensor behind the position from which on trims act
  double step_mm = 0.5;      ///< distance by which the nozzle moves from call to call
  double growth = 1.0;       ///< gain learnt, actual over commanded growth; 0: no prediction
  double range = 0.2;        ///< greatest magnitude of the trim
};

/// The trim that the settings of the loop ask for; none if they ask for none.
/// @param growth  gain learnt, as in `TrimSettings`
std::optional<TrimSettings> trimOf(const LoopSettings& settings, double step_mm, double growth);

/// Trims the amount within a layer, to remove slow drift of a feeder. A Smith predictor [Smith1957] computes
/// the effect of the trims that are under way between nozzle and sensor, and only the rest of the error is
/// fed back. So the distance of the sensor does not reduce stability as long as the gain is known.
class TrailingTrim {
 public:
  /// @throws InvalidInput if step or distance is not positive, or the distance is above 10^5 steps
  explicit TrailingTrim(const TrimSettings& settings);

  /// Moves the nozzle on by a step.
  /// @param relative_error  of the growth under the sensor, positive if too much; none, or not finite, where
  ///   the sensor shows nothing: the trim then stays
  /// @return the trim to add to the amount from here on
  double advance(std::optional<double> relative_error);

  /// Replaces, from here on, the trim that `advance` has given, for a caller with a bound of its own. The
  /// predictor does not expect an effect of the part cut off.
  void replace(double trim);

  /// The present trim.
  double trim() const { return trim_; }

 private:
  TrimSettings settings_;
  std::vector<double> under_way_;  ///< trims, the oldest at `next_`
  std::size_t next_ = 0;
  double trim_ = 0.0;
};

}  // namespace lamina
