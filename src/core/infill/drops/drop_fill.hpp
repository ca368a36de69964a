// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "infill/rectilinear/raster.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Drops along a closed outline: one at each corner (a turn by more than 50 degrees), and between corners as
/// many, evenly, as keep the pitch along the outline. Corners nearer to the one before than the pitch have
/// none of their own. An outline shorter than the pitch has one drop. Where drops would stand more than a
/// quarter of the pitch too far apart there is one more, if `least_mm` is kept then.
Polyline dropsAlong(const Polygon& outline, double pitch_mm, double least_mm);

/// @throws InvalidInput if these regions of a layer have room for more than 5 million drops
void requireFewDrops(const Regions& regions, const DropSettings& settings);

/// Drops of one line of a raster, from left to right [raster frame].
using DropLine = std::function<std::vector<double>(std::int64_t line, double left, double right)>;

/// Lays the drops of a layer in order and leaves out those too near to one that lies already.
class DropFill {
 public:
  /// @throws InvalidInput if diameter, pitch or line spacing are not positive or too small for the regions
  DropFill(const Regions& regions, const DropSettings& settings);

  /// Contours round the regions, from outside: the first at half a diameter from the border, the next a line
  /// spacing further inside, until `most` are deposited or none fits. Each starts beside where the one before
  /// ended. Those of the border are outer walls, the others inner ones. Where the first would run back beside
  /// itself too near for two rows there is one row instead, as infill.
  void addContours(const Regions& regions, std::size_t most);

  /// What is left inside the contours for centres of drops, a line spacing off the innermost one.
  Regions inside(const Regions& regions, std::size_t contours) const;

  /// Lines of drops to and fro, in runs that go from line to line.
  void addLines(const Raster& raster, const RasterFrame& frame, const DropLine& line);

  std::vector<FillPath> take() && { return std::move(paths_); }

 private:
  /// Loops that show on the part's surface have no wide gap.
  void addLoops(const Regions& regions, PathRole role);
  void add(const Polyline& drops, PathRole role);
  Polyline startedNear(Polyline loop) const;

  DropSettings settings_;
  double least_distance_;
  PointGrid deposited_;
  std::vector<FillPath> paths_;
};

/// A layer of drops: contours (`drops.contours`), then lines `row_mm` apart at the request's angle.
std::vector<FillPath> contoursAndLines(const Regions& regions, const InfillRequest& request, double row_mm,
                                       const DropLine& line);

}  // namespace lamina
