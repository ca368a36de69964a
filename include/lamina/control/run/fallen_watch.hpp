// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "lamina/control/height_loop.hpp"

namespace lamina {

/// Detects where a piece of a layer came off, or the whole wall did: points over the crowns of cells lie
/// below the range in which points are assigned to them, and none lies within it.
class FallenWatch {
 public:
  /// Adds a point over the crown of a cell.
  /// @param depth_mm  distance below the cell's planned top
  void see(std::size_t cell, double depth_mm);
  /// Forgets all points.
  void reset() { depths_mm_.clear(); }

  /// The stretches of cells not seen, at least three bead widths long, in which at least a third of the cells
  /// have such points. Shorter ones may be the ends of beads that lie a little off their place. The highest
  /// point of a cell counts.
  FallenLength fallen(const LayerCells& cells, const std::vector<CellEstimate>& estimates) const;

 private:
  std::map<std::size_t, double> depths_mm_;  ///< least depth, by cell
};

}  // namespace lamina
