// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Deviations of an emulated process from the commanded growth. With the defaults there are none.
struct PlantSettings {
  bool pressed = false;    ///< whether the nozzle makes the top of a bead (`GrownDeposit`)
  double gain = 1.0;       ///< growth over commanded growth, at the start of the job
  double wear = 0.0;       ///< share of the gain that is lost over the job
  double end_loss = 0.0;   ///< share of the growth that is lost at the ends of beads
  double end_mm = 10.0;    ///< length over which ends are lower
  double wave = 0.0;       ///< amplitude of a wave of growth along a bead, relative
  double wave_mm = 80.0;   ///< length of that wave
  double random = 0.0;     ///< standard deviation of the random part of growth, in layer heights
  double random_mm = 5.0;  ///< correlation length of the random part
  /// Relative loss of growth per layer height of excess nozzle stand-off.
  double standoff = 0.0;
  double levelling_mm = 0.0;  ///< standard deviation of the Gaussian by which the surface levels itself
  double dead_time_s = 0.0;   ///< dead time of the feeder
  double lag_s = 0.0;         ///< time constant of the feeder's first-order lag
  double thermal = 0.0;       ///< share of a layer's height lost by settling, per 100 K of residual heat
  double cooling_s = 60.0;    ///< time constant by which the wall cools
  double slump_s = 20.0;      ///< time constant by which a layer settles
  /// Offset of the nozzle from where it should be: x along the bead, y across, z upwards; empty: none.
  std::vector<double> nozzle_offset_mm;
  double z_error_mm = 0.0;  ///< error of the vertical axis; positive if the nozzle is too high
  double clog = 0.0;        ///< share of the gain that is lost to a clog
  int clog_at_layer = 0;    ///< first layer of the clog, from 1; 0: none
  int detach_at_layer = 0;  ///< layer, from 1, before which the middle 30 mm of each bead break off; 0: none
  int seed = 1;             ///< seed of the random part
};

/// Adds the keys plant.*.
void describe(SettingsSchema& schema, PlantSettings& settings);

/// Whether growth differs from the commanded one by any of the settings.
bool isDisturbed(const PlantSettings& settings);

/// A bead as it is deposited; the vectors have one value per cell.
struct PlantBead {
  std::size_t layer = 0;   ///< number of the layer, from 0
  std::size_t layers = 1;  ///< number of layers of the job
  std::uint64_t path = 0;  ///< number that distinguishes the beads of a layer
  double length_mm = 0.0;
  bool is_closed = false;
  double layer_s = 0.0;               ///< time from layer to layer; 0: growth does not depend on time
  std::vector<double> along_mm;       ///< distance of the cell from the start of the bead, equally spaced
  std::vector<double> planned_mm;     ///< planned height of the layer
  std::vector<double> correction;     ///< relative change of the amount that arrives
  std::vector<double> nozzle_far_mm;  ///< excess of the nozzle's stand-off over the planned height
};

/// A process whose growth differs from the commanded one. It has no state: the same bead over the same
/// surface gives the same growth.
///
/// growth = planned · gain · stand-off · (1 + correction) + random part. The gain (`gainAt`) falls linearly
/// over the job by wear, and by a constant share from the layer of a clog on. Its loss at the ends of an open
/// bead tapers off linearly over `end_mm`. A sine wave modulates it along the bead. The layer then settles by
/// the residual heat of the layers below, and a Gaussian filter levels the surface.
class GrowthPlant {
 public:
  explicit GrowthPlant(PlantSettings settings);

  /// Heights after the bead was deposited onto the given ones [mm]. Without deviations the heights grow by
  /// exactly the planned height times (1 + correction).
  std::vector<double> afterBead(const PlantBead& bead, std::vector<double> heights) const;

  /// Growth over commanded growth at a position on a bead: gain, wear, clog, ends and wave, without the
  /// random part.
  double gainAt(const PlantBead& bead, double along_mm) const;
  /// The random part of growth at a position on a bead, in layer heights.
  double randomAt(const PlantBead& bead, double along_mm) const;
  /// Share of a layer's height by which it settles.
  double settling(const PlantBead& bead) const;
  /// Excess height of the nozzle [mm].
  double nozzleAbove() const;

  const PlantSettings& settings() const { return settings_; }

 private:
  PlantSettings settings_;
};

/// A quantity over time, linear between its values; constant before the first and after the last one.
struct TimedValues {
  std::vector<double> time_s;  ///< ascending
  std::vector<double> value;
};

/// The values of a commanded quantity that arrive at given times: after the dead time, and with a first-order
/// lag that begins at the first of the times.
/// @param time_s  ascending
std::vector<double> delayed(const TimedValues& commanded, const std::vector<double>& time_s,
                            const PlantSettings& settings);

/// Random function of the position along a bead, with mean 0 and standard deviation 1: white noise smoothed
/// by a Gaussian. The same seed gives the same function.
/// @param length_mm  standard deviation of that Gaussian; positive
double correlatedNoise(std::uint64_t seed, double along_mm, double length_mm);

}  // namespace lamina
