// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What is wrong with an emulated process. With the values below nothing is.
struct PlantSettings {
  double gain = 1.0;  ///< growth over commanded growth, at the start
  double wear = 0.0;  ///< of that, lost over the job
  double end_loss = 0.0;
  double end_mm = 10.0;
  double wave = 0.0;
  double wave_mm = 80.0;
  double random = 0.0;
  double random_mm = 5.0;
  double standoff = 0.0;  ///< loss of growth per nozzle too far away, in layer heights
  double levelling_mm = 0.0;
  double dead_time_s = 0.0;
  double lag_s = 0.0;
  double thermal = 0.0;  ///< part of the layer that settles per 100 K
  double cooling_s = 60.0;
  double slump_s = 20.0;
  std::vector<double> nozzle_offset_mm;  ///< x along the bead, y across, z away from it; empty for none
  double z_error_mm = 0.0;
  double clog = 0.0;
  int clog_at_layer = 0;    ///< from 1; 0 for never
  int detach_at_layer = 0;  ///< from 1; 0 for never
  int seed = 1;
};

/// Adds the keys plant.*.
void describe(SettingsSchema& schema, PlantSettings& settings);

/// Whether any of it makes growth other than commanded.
bool isDisturbed(const PlantSettings& settings);

/// One bead as it is deposited; the vectors have one value per cell.
struct PlantBead {
  std::size_t layer = 0;   ///< from 0
  std::size_t layers = 1;  ///< of the whole job
  std::uint64_t path = 0;  ///< distinguishes the beads of a layer
  double length_mm = 0.0;
  bool is_closed = false;
  double layer_s = 0.0;               ///< from layer to layer; 0 if nothing depends on time
  std::vector<double> along_mm;       ///< from the start of the bead, equally spaced
  std::vector<double> planned_mm;     ///< height of the layer
  std::vector<double> correction;     ///< relative change of the amount that arrives
  std::vector<double> nozzle_far_mm;  ///< nozzle above the height at which it should be over the surface
};

/// A process that grows otherwise than commanded: a value without state, so that the same bead over the same
/// surface gives the same growth.
///
/// growth = planned · gain · place · stand-off · (1 + correction) + random, and the surface with it levels
/// itself by a Gaussian; then it settles by the heat that is left of the layers below. The gain wears
/// linearly over the job and is lost in part from the layer of a clog on; beads are lower at their ends,
/// linearly over `end_mm`.
class GrowthPlant {
 public:
  explicit GrowthPlant(PlantSettings settings);

  /// Heights after the bead was deposited onto them [mm]. Without disturbances these are exactly the heights,
  /// the planned ones and the corrections added.
  std::vector<double> afterBead(const PlantBead& bead, std::vector<double> heights) const;

  /// Growth over commanded growth at a place of a bead: gain, ends, wave, not the random part.
  double gainAt(const PlantBead& bead, double along_mm) const;

  const PlantSettings& settings() const { return settings_; }

 private:
  double randomAt(const PlantBead& bead, double along_mm) const;
  double settling(const PlantBead& bead) const;

  PlantSettings settings_;
};

/// A quantity by time; before the first value it is the first, after the last one the last.
struct TimedValues {
  std::vector<double> time_s;  ///< ascending
  std::vector<double> value;
};

/// What arrives of a commanded quantity at these times, ascending: after a dead time, and as a first-order
/// lag follows.
std::vector<double> delayed(const TimedValues& commanded, const std::vector<double>& time_s,
                            const PlantSettings& settings);

/// Standard deviation 1, the same for the same seed and bead: white noise smoothed by a Gaussian.
/// @param length_mm  standard deviation of that Gaussian; positive
double correlatedNoise(std::uint64_t seed, double along_mm, double length_mm);

}  // namespace lamina
