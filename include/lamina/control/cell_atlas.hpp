// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "lamina/control/layer_cells.hpp"

namespace lamina {

class CellSheet;

/// A point that lies on a cell, in coordinates of the cell.
struct CellSight {
  std::size_t layer = 0;
  std::size_t cell = 0;
  double off_mm = 0.0;  ///< distance of the point from the cell's middle along the cell's tangent
  /// Distance from the bead's middle line; positive on the left, seen against growth.
  double across_mm = 0.0;
  double across_share = 0.0;  ///< magnitude of `across_mm` over the bead's width
  double error_mm = 0.0;  ///< planned less measured height along the growth direction; positive if too low
};

/// The cells of deposited beads on which a point may lie.
struct PointSights {
  std::optional<CellSight> newest;  ///< cell of the newest layer that has one there
  std::optional<CellSight> below;   ///< cell of the next layer below that has one there
};

/// Finds the cell of the deposited layers on which a point lies [mm, frame of the toolpath], for layers of
/// any shape.
///
/// A point lies on a cell if its distance from the middle of the planned top is at most half the cell's
/// length along the path, half the bead's width across it, and `window_layers` planned heights along the
/// growth direction. Length and width are taken 2 % greater, since beads fan out above a crest. On the
/// outside of bends, where gaps open between the cells of a bead, up to half the length more is allowed. If
/// several cells of one bead qualify, the nearest along the path is taken; of cells of several beads, the one
/// whose middle is nearest in bead widths, and of equally near ones the one deposited first. The result does
/// not depend on the order in which points are looked up.
///
/// The cost of a look-up does not depend on the number of cells. A layer that lies along a plane is indexed
/// by squares of that plane, any other by cubes.
class CellAtlas {
 public:
  /// @param window_layers  distance along the growth direction, either way, within which a point lies on a
  ///   cell, in planned heights of the cell; positive
  /// @throws InvalidInput if `window_layers` is not positive and finite
  explicit CellAtlas(double window_layers = 1.5);
  CellAtlas(CellAtlas&&) noexcept;
  CellAtlas& operator=(CellAtlas&&) noexcept;
  ~CellAtlas();

  /// Adds a layer with all of its cells deposited. A layer of the same number is replaced.
  /// @throws InvalidInput if the pointer is null
  void add(std::shared_ptr<const LayerCells> cells);

  /// States that only the first `cells` cells of a layer are deposited (`cellsPassed`). Without effect if the
  /// layer is not in the atlas.
  void setDeposited(std::size_t layer, std::size_t cells);

  /// Removes all layers below `layer`. In a scan pass only the scanned layer counts.
  void forgetBelow(std::size_t layer);

  /// The cells on which a point lies; none for a point that is not finite.
  PointSights look(const Point3& point) const;
  /// `PointSights::newest` alone, at less cost.
  std::optional<CellSight> newestAt(const Point3& point) const;
  /// `newestAt` of many points, one entry each, in a fraction of the time that single calls take.
  std::vector<std::optional<CellSight>> newestAt(const std::vector<Point3>& points) const;
  /// The cell at a point in the next layer below `layer` that has a cell there.
  std::optional<CellSight> belowAt(const Point3& point, std::size_t layer) const;

  /// The cells of a layer; null if it is not in the atlas.
  std::shared_ptr<const LayerCells> cellsOf(std::size_t layer) const;
  /// Whether all cells of a layer have the same growth direction; false if the layer is not in the atlas.
  bool isPlane(std::size_t layer) const;
  /// Numbers of the layers, ascending.
  std::vector<std::size_t> layers() const;
  /// Memory of the index [bytes], without the cells themselves.
  std::size_t bytes() const;

 private:
  const CellSheet* sheetOf(std::size_t layer) const;

  std::vector<CellSheet> sheets_;  ///< ascending by layer
  double window_layers_;
};

}  // namespace lamina
