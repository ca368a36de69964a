// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/base/settings.hpp"

namespace lamina {

/// What sets the top of a bead.
enum class LoopProcess : std::uint8_t {
  Free,    ///< volume per millimetre: wire, powder, paste laid from above; errors add up
  Pressed  ///< the nozzle's plane: filament, pellets; errors are forgotten
};

/// At what height the nozzle runs.
enum class NozzleHeight : std::uint8_t {
  Plan,    ///< as planned
  Layer,   ///< planned, less the mean error of the layer
  Surface  ///< the measured surface, low-passed, and the stand-off
};

/// What is done where corrections have come to their limits.
enum class Replanning : std::uint8_t {
  Off,    ///< it is told, and the print goes on
  Hold,   ///< the operator is asked
  Scale,  ///< heights of the layers left are scaled
  Add     ///< whole layers are added or left out, dips are filled
};

/// What is done where measurements stay away for three layers.
enum class LossOfSight : std::uint8_t { Hold, Open };

/// What is done with a low-pass that is too narrow to be stable.
enum class NarrowLowPass : std::uint8_t { Refused, Raised };

/// The loop that changes what is laid next by what was measured.
struct LoopSettings {
  LoopProcess process = LoopProcess::Free;
  double gain = 0.5;           ///< share of the error corrected per layer
  double learning = 0.3;       ///< share of what is learnt of growth per layer
  double least_amount = -0.4;  ///< of the relative change of the amount laid
  double greatest_amount = 0.5;
  double low_pass_mm = 3.0;  ///< standard deviation of the Gaussian over corrections
  NarrowLowPass narrow_low_pass = NarrowLowPass::Refused;
  double feeder_rate_s = 0.5;  ///< greatest change of the amount per second
  double layer_volume = 0.2;   ///< greatest change of a layer's volume
  int first_layers = 2;        ///< not corrected, only learnt from
  double min_coverage = 0.5;   ///< part of the cells seen, below which a layer is unmeasured
  NozzleHeight z = NozzleHeight::Plan;
  double growth_spread = 0.1;        ///< relative standard deviation of growth, at first
  double reading_correlation = 0.2;  ///< between neighbouring points of one profile
  double dead_time_s = 0.0;          ///< of feeder and link
  double lag_s = 0.0;                ///< of the feeder, first order
  double trim = 0.0;                 ///< gain of the trailing sensor times its distance; 0 for none
  double sensor_behind_mm = 0.0;     ///< the trailing sensor, behind the nozzle
  double trim_lead_mm = 0.0;         ///< ahead of the nozzle, from where on a trim acts
  Replanning replan = Replanning::Hold;
  LossOfSight on_loss = LossOfSight::Hold;
  double silence_s = 2.0;       ///< without a cloud within a scan
  double wait_s = 2.0;          ///< for the map at the start of a layer
  double alarm_layers = 1.0;    ///< error that counts as deviating, in layer heights
  double speed_exponent = 0.0;  ///< growth goes with speed to that power; 0: speed is left alone
  double least_speed_mm_s = 3.0;
  double greatest_speed_mm_s = 17.0;
  double heat = 0.15;          ///< greatest change of power over speed
  double interpass_c = 0.0;    ///< to wait for before a layer; 0 for none
  double part_learning = 0.5;  ///< gain from part to part
};

/// Adds the keys loop.*.
void describe(SettingsSchema& schema, LoopSettings& settings);

/// Adds those of the keys loop.* that say what the feeder follows, and how late.
void describeFeeding(SettingsSchema& schema, LoopSettings& settings);

/// Range of the relative change of the amount laid.
inline double amountRange(const LoopSettings& settings) {
  return settings.greatest_amount - settings.least_amount;
}

}  // namespace lamina
