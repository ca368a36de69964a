// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// The quantity that determines the height of a bead's top.
enum class LoopProcess : std::uint8_t {
  Free,    ///< volume per length: wire, powder, paste deposited from above; errors of layers add up
  Pressed  ///< the plane of the nozzle: filament, pellets; errors do not carry over to the next layer
};

/// Height at which the nozzle runs, as `nozzleShift` computes it.
enum class NozzleHeight : std::uint8_t {
  Plan,    ///< as planned
  Layer,   ///< the plan, shifted in each layer as a whole by the mean error
  Surface  ///< free process: follows the measured surface, low-passed; pressed process: as `Layer`
};

/// What is done when corrections have reached their limits.
enum class Replanning : std::uint8_t {
  Off,    ///< a warning is raised, and the print continues
  Hold,   ///< the operator is asked
  Scale,  ///< heights of the layers left are scaled
  Add     ///< whole layers are added or left out, dips are filled
};

/// Reaction to three unmeasured layers in a row: the operator is asked, or the loop goes to state Open.
enum class LossOfSight : std::uint8_t { Hold, Open };

/// Reaction to a low-pass that is too narrow for stability: the loop does not start, or the low-pass is
/// widened.
enum class NarrowLowPass : std::uint8_t { Refused, Raised };

/// Settings of the loop, which corrects the next deposits by the measured heights. Amounts are relative
/// changes of the volume per length.
struct LoopSettings {
  LoopProcess process = LoopProcess::Free;
  double gain = 0.5;  ///< share of the height error corrected per layer
  /// Share of the difference between measured and learnt gain that is learnt per layer.
  double learning = 0.3;
  double least_amount = -0.4;    ///< lower limit of the relative change of the amount deposited
  double greatest_amount = 0.5;  ///< upper limit of that change
  double low_pass_mm = 3.0;      ///< standard deviation of the Gaussian over corrections
  NarrowLowPass narrow_low_pass = NarrowLowPass::Refused;
  double feeder_rate_s = 0.5;  ///< greatest change of the relative amount that the feeder follows [1/s]
  double layer_volume = 0.2;   ///< greatest relative change of a layer's volume
  /// Number of layers, from the first, that are measured and learnt from, but not corrected.
  int first_layers = 2;
  double min_coverage = 0.5;  ///< share of cells seen, below which a layer is unmeasured
  NozzleHeight z = NozzleHeight::Plan;
  double growth_spread = 0.1;        ///< relative standard deviation of growth, initially
  double reading_correlation = 0.2;  ///< correlation of neighbouring points of one profile
  double dead_time_s = 0.0;          ///< dead time of feeder and link
  double lag_s = 0.0;                ///< time constant of the feeder's first-order lag
  double trim = 0.0;  ///< gain of the trim by a trailing sensor [1/mm] times its distance; 0: no trim
  double sensor_behind_mm = 0.0;  ///< distance of the trailing sensor behind the nozzle
  double trim_lead_mm = 0.0;      ///< distance ahead of the nozzle from which on a trim acts
  Replanning replan = Replanning::Hold;
  LossOfSight on_loss = LossOfSight::Hold;
  double silence_s = 2.0;     ///< longest time without a cloud during a scan
  double wait_s = 2.0;        ///< longest wait for the map at the start of a layer
  double alarm_layers = 1.0;  ///< height error that counts as deviating, in layer heights
  /// Exponent of the travel speed to which growth is proportional; 0: speed stays as planned.
  double speed_exponent = 0.0;
  double least_speed_mm_s = 3.0;
  double greatest_speed_mm_s = 17.0;
  double heat = 0.15;          ///< greatest relative change of the heat per length, power over speed
  double part_learning = 0.5;  ///< share of the remaining error that is corrected from part to part
};

/// Adds the keys loop.*.
void describe(SettingsSchema& schema, LoopSettings& settings);

/// Adds the keys loop.* for limits and delay of the feeder.
void describeFeeding(SettingsSchema& schema, LoopSettings& settings);

/// Greatest less least relative change of the amount deposited.
inline double amountRange(const LoopSettings& settings) {
  return settings.greatest_amount - settings.least_amount;
}

}  // namespace lamina
