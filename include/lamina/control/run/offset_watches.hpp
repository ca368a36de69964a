// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "lamina/control/run/loop_run_settings.hpp"
#include "lamina/control/run/offset_watch.hpp"
#include "lamina/control/supervision.hpp"

namespace lamina {

/// The remaining time offset of one of several sensors.
struct SensorOffset {
  std::string sensor;  ///< its name
  OffsetLeft left;     ///< its standard deviation includes that of the calibrated offset

  /// Magnitude of the offset in standard deviations; 0 if there is no standard deviation.
  double sigmas() const;
};

/// Estimates the time offsets of several sensors over a layer (`OffsetWatch`), each from its own readings. A
/// mean over two sensors would show half the offset of one that has moved, and nothing of two opposite
/// offsets.
class OffsetWatches {
 public:
  /// Begins a layer with that number of cells.
  void begin(std::size_t cells);

  /// Adds a reading by a sensor, as `OffsetWatch::see`.
  /// @param speed_mm_s  of that sensor along the cell's path
  void see(const std::string& sensor, std::size_t cell, double speed_mm_s, const CellReading& reading);

  /// The offset of the sensor whose offset is the largest in standard deviations, of equal ones the first by
  /// name; none if no sensor gives an estimate.
  /// @param cells       of the layer that was begun
  /// @param calibrated  standard deviations of the calibrated offsets
  std::optional<SensorOffset> offset(const LayerCells& cells, const TimeOffsetSigmas& calibrated) const;

 private:
  std::size_t cells_ = 0;
  std::map<std::string, OffsetWatch> watches_;  ///< of sensors that have read the layer
};

/// Fills in the members by which `afterWatch` judges a time offset.
void judge(const SensorOffset& offset, SensorWatch& seen);

}  // namespace lamina
