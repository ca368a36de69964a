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

/// A point on a cell.
struct CellSight {
  std::size_t layer = 0;
  std::size_t cell = 0;
  double off_mm = 0.0;        ///< from the cell's middle, along its tangent
  double across_mm = 0.0;     ///< from the bead's middle, positive to its left seen against growth
  double across_share = 0.0;  ///< magnitude of `across_mm` over the bead's width
  double error_mm = 0.0;  ///< planned less measured height along the growth direction: positive is too low
};

/// The cells of deposited beads on which a point may lie.
struct PointSights {
  std::optional<CellSight> newest;  ///< of the newest layer that has a cell there
  std::optional<CellSight> below;   ///< of the next layer below that has a cell there
};

/// Finds the cell of the deposited layers on which a point lies [mm, frame of the toolpath], for layers of
/// any shape.
///
/// A point lies on a cell if it is away from the cell's middle by at most half the cell's length along the
/// path, half the bead's width across it, and `window_layers` planned heights from the planned top along the
/// growth direction. Length and width count a fiftieth more, since beads fan out above a crest; the length up
/// to half as much again along the outside of bends, where cells gape. Among neighbouring cells of one bead
/// the nearest along the path is taken, among several beads the one whose middle is nearest in bead widths,
/// among equals the one deposited first. The order in which points are looked up changes nothing.
///
/// The cost of a look-up does not depend on the number of cells. A layer that lies along a plane is indexed
/// by squares of that plane, any other by cubes.
class CellAtlas {
 public:
  /// @param window_layers  reach along the growth direction, in planned heights of the cell; positive
  /// @throws InvalidInput if that is not positive and finite
  explicit CellAtlas(double window_layers = 1.5);
  CellAtlas(CellAtlas&&) noexcept;
  CellAtlas& operator=(CellAtlas&&) noexcept;
  ~CellAtlas();

  /// Adds a layer with all its cells deposited, in place of one of the same number.
  /// @throws InvalidInput if the pointer is null
  void add(std::shared_ptr<const LayerCells> cells);

  /// States that only the first `cells` cells of a layer are deposited (`cellsPassed`). Without effect if the
  /// layer is not in the atlas.
  void setDeposited(std::size_t layer, std::size_t cells);

  /// Removes all layers below `layer`: in a scan pass only the scanned layer counts.
  void forgetBelow(std::size_t layer);

  /// The cells on which a point lies; none for a point that is not finite.
  PointSights look(const Point3& point) const;
  /// `PointSights::newest` alone.
  std::optional<CellSight> newestAt(const Point3& point) const;
  /// The same for many points, in a fraction of the time that single calls take.
  std::vector<std::optional<CellSight>> newestAt(const std::vector<Point3>& points) const;
  /// The cell at that point of the next layer below `layer` that has one there.
  std::optional<CellSight> belowAt(const Point3& point, std::size_t layer) const;

  /// The cells of a layer; null if it is not in the atlas.
  std::shared_ptr<const LayerCells> cellsOf(std::size_t layer) const;
  /// Whether all cells of a layer have the same growth direction.
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
