// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/control/cell_estimate.hpp"
#include "lamina/control/layer_cells.hpp"

namespace lamina {

/// The remaining time offset of a sensor after removal of the calibrated one.
struct OffsetLeft {
  double offset_s = 0.0;  ///< true time is the time stamp less this
  double sigma_s = 0.0;   ///< standard deviation of the offset
};

/// Estimates the time offset of a sensor from a layer that is scanned in both directions along its paths. An
/// offset shifts the measured heights along the path, forwards on the outward pass and backwards on the
/// return pass. Therefore the two readings of a cell differ by twice the speed times the offset times the
/// slope of the heights along the path.
///
/// It needs 32 bytes per cell from the first reading on. A layer whose slopes do not exceed the noise, or
/// with fewer than eight cells that show the offset, gives no estimate.
class OffsetWatch {
 public:
  /// Begins a layer with that number of cells.
  void begin(std::size_t cells);

  /// Adds a reading by a sensor that moves along the cell's path at a speed [mm/s], negative against the
  /// direction of the path. It is ignored if the speed is below 1 mm/s either way or not finite.
  void see(std::size_t cell, double speed_mm_s, const CellReading& reading);

  /// The offset by least squares over the cells read in both directions; none if there is no estimate, or its
  /// standard deviation is above 10 ms.
  /// @param cells  of the layer that was begun
  std::optional<OffsetLeft> offset(const LayerCells& cells) const;

 private:
  /// Sums over the readings in one direction.
  struct Seen {
    float readings = 0.0F;
    float error_mm = 0.0F;      ///< sum
    float speed_mm_s = 0.0F;    ///< sum, without sign
    float variance_mm2 = 0.0F;  ///< sum
  };
  std::size_t cells_ = 0;
  std::vector<std::array<Seen, 2>> seen_;  ///< by cell: along the path, and against it; empty before any
  std::array<bool, 2> is_seen_ = {false, false};  ///< whether there are readings in that direction
};

}  // namespace lamina
