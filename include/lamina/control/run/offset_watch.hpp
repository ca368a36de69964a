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

/// The offset of a sensor's clock that is left after the calibrated offset is removed.
struct OffsetLeft {
  double offset_s = 0.0;  ///< true time is the stamp less this
  double sigma_s = 0.0;   ///< standard deviation of that
};

/// Estimates the offset of stamps from a layer that is scanned in both directions along its paths. An offset
/// shifts the heights seen along the path, in opposite senses on the way there and back. The two readings of
/// a cell then differ by twice speed times offset times the slope of the heights along the path.
///
/// It takes 32 bytes per cell from the first reading on. A layer as even as its noise, or without cells seen
/// in both directions, gives no estimate.
class OffsetWatch {
 public:
  /// Begins a layer with that number of cells.
  void begin(std::size_t cells);

  /// Takes a reading by a sensor that moves along the cell's path at that speed [mm/s], negative against the
  /// direction of the path. It is left out if the speed is below 1 mm/s or not finite.
  void see(std::size_t cell, double speed_mm_s, const CellReading& reading);

  /// The offset by least squares over the cells seen in both directions; none if its standard deviation is
  /// above 10 ms.
  /// @param cells  of the layer
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
  std::array<bool, 2> is_seen_ = {false, false};  ///< in that sense
};

}  // namespace lamina
