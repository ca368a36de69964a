// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "lamina/geometry/voxel/height_map.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The top surface that a toolpath should give, layer by layer: each bead, or drop, is as wide as planned and
/// as high as the nozzle ran; elsewhere the height is that of earlier layers, or unknown. Takes time in
/// proportion to the deposited length.
class ExpectedSurface {
 public:
  /// @param heights_from_part  frame of the grid and the heights, translation [mm]
  ExpectedSurface(const HeightGrid& grid, const Eigen::Isometry3d& heights_from_part);

  /// Adds what the next layer deposits.
  void addLayer(const ToolpathLayer& layer);

  /// Heights after the layers added so far [mm].
  const HeightMap& heights() const { return heights_; }

  /// Cells of the latest layer, without the skirt, that should be as high as the nozzle ran: their centres
  /// lie on the flat top of a bead. The flat top extends on either side of the centre line by (width -
  /// height) / 2, where the rounded edges begin, and by half a cell at least. In no particular order, each
  /// once.
  const std::vector<std::size_t>& topCells() const { return top_cells_; }

 private:
  void addMotion(const Point3& start, const Point3& end, const Bead& bead, PathRole role);

  HeightMap heights_;
  Eigen::Isometry3d heights_from_part_;
  std::vector<std::uint32_t> top_in_layer_;  ///< latest layer (from 1) that has the cell among its top cells
  std::vector<std::size_t> top_cells_;
  std::uint32_t layers_ = 0;
};

}  // namespace lamina
