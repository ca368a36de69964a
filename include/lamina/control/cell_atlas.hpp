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
  double off_mm = 0.0;        ///< along the cell's tangent, from its middle
  double across_mm = 0.0;     ///< from the bead's middle, positive to the left of its way seen against growth
  double across_share = 0.0;  ///< of the bead's width, without sign
  double error_mm = 0.0;  ///< planned less measured height along the growth direction: positive is too low
};

/// The cells of laid beads that a point may lie on: one of the newest layer that has one there, and one of
/// the next below that has.
struct PointSights {
  std::optional<CellSight> newest;
  std::optional<CellSight> beneath;
};

/// Which cell of which laid layer a point in the toolpath's frame lies on, for layers of any shape.
///
/// A point lies on a cell where it is within half the cell's length along the path, half the bead's width
/// across, each and a fiftieth for beads that fan out above a crest, and `window_layers` planned heights of
/// the planned top along the growth direction. Along the outside of bends, where cells gape, the length
/// counts by up to half as much again. Of neighbouring cells
/// of one bead the nearer along counts; of several beads the one whose middle is nearer, in bead widths; of
/// equals the one laid first. So the order of points changes nothing.
///
/// Asking costs the same however many cells there are. Layers are looked up in squares of
/// a plane that they lie along, those that go all ways round in cubes.
class CellAtlas {
 public:
  /// @param window_layers  reach along the growth direction, in planned heights of the cell; positive
  /// @throws InvalidInput if that is not positive and finite
  explicit CellAtlas(double window_layers = 1.5);
  CellAtlas(CellAtlas&&) noexcept;
  CellAtlas& operator=(CellAtlas&&) noexcept;
  ~CellAtlas();

  /// Adds a layer, all of it laid; it takes the place of one of the same number.
  /// @throws InvalidInput if there are no cells to point to
  void add(std::shared_ptr<const LayerCells> cells);

  /// Only the first so many cells of a layer are laid (`cellsPassed`); does nothing if it is not there.
  void setLaid(std::size_t layer, std::size_t cells);

  /// Forgets the layers below one: in a scan pass of a layer only that layer counts.
  void forgetBelow(std::size_t layer);

  /// A point that is not finite lies on no cell.
  PointSights look(const Point3& point) const;
  /// The first of these alone.
  std::optional<CellSight> newestAt(const Point3& point) const;
  /// The same of many points, in a fraction of the time.
  std::vector<std::optional<CellSight>> newestAt(const std::vector<Point3>& points) const;
  /// A cell of the next layer below one that has one there.
  std::optional<CellSight> beneathAt(const Point3& point, std::size_t layer) const;

  /// None if the layer is not there.
  std::shared_ptr<const LayerCells> cellsOf(std::size_t layer) const;
  /// Whether all cells of a layer grow one way.
  bool isPlane(std::size_t layer) const;
  /// Numbers of the layers, ascending.
  std::vector<std::size_t> layers() const;
  /// Memory of the look-up [bytes], the cells themselves not counted.
  std::size_t bytes() const;

 private:
  const CellSheet* sheetOf(std::size_t layer) const;

  std::vector<CellSheet> sheets_;  ///< ascending by layer
  double window_layers_;
};

}  // namespace lamina
