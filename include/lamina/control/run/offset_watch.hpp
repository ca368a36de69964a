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

/// What is left of the offset of a sensor's clock once the calibrated one is off.
struct OffsetLeft {
  double offset_s = 0.0;  ///< true time is the stamp less this
  double sigma_s = 0.0;   ///< standard deviation of that
};

/// Tells from a layer that is scanned there and back whether stamps are still right: a wrong one moves what
/// is seen along the way, to one side on the way there and to the other on the way back. What both saw of a
/// cell then differs by twice speed times offset times the slope of the heights along the path.
///
/// 32 bytes a cell, from the first reading on. A layer that is as even as its noise, or that no cell of is
/// seen in both senses, tells nothing.
class OffsetWatch {
 public:
  /// A new layer of so many cells: nothing is seen of it yet.
  void begin(std::size_t cells);

  /// A reading by a sensor that moves along the cell's path at that speed, negative against its sense
  /// [mm/s]. One that is slower than 1 mm/s, or whose speed is not finite, is left out.
  void see(std::size_t cell, double speed_mm_s, const CellReading& reading);

  /// The offset by least squares over the cells that were seen in both senses; none where its standard
  /// deviation is above 10 ms.
  /// @param cells  of the layer
  std::optional<OffsetLeft> offset(const LayerCells& cells) const;

 private:
  /// Readings in one sense.
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
