// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "geometry/spatial/box_cells.hpp"
#include "lamina/control/layer_cells.hpp"

namespace lamina {

/// Finds the cells of a layer that may hold a point. If no cell leans from the plane of the layer by more
/// than 60 degrees, cells are indexed by squares in that plane, otherwise by cubes.
class StationIndex {
 public:
  static constexpr double kAcross = 0.51;  ///< reach of a cell across the bead [bead widths]

  StationIndex(const LayerCells& cells, double window_layers);

  /// Whether all cells have the same growth direction.
  bool isPlane() const { return is_plane_; }
  /// A point in the axes of the index: two coordinates in the plane, and one along its normal.
  Point3 placeOf(const Point3& point) const { return axes_ * point - low_; }
  Eigen::Vector3d turned(const Eigen::Vector3d& direction) const { return axes_ * direction; }

  /// The stations, indexed by their coordinates in these axes (`placeOf`).
  const BoxCells& stations() const { return stations_; }

 private:
  CellSpace layOut(const LayerCells& cells);
  Point3 reachOf(const LayerCells& cells, const CellRun& run, std::size_t cell) const;

  double window_layers_;
  bool is_plane_ = true;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  ///< rows: two axes in the plane, and its normal
  Point3 low_ = Point3::Zero();
  BoxCells stations_;
};

}  // namespace lamina
