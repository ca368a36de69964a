// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "infill/rectilinear/raster.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Drops along a closed outline: one at each corner (a turn by more than 50 degrees), and between corners the
/// greatest number of evenly spaced drops that are at least the pitch apart along the outline. A corner
/// closer to the one before than the pitch has no drop of its own. An outline shorter than the pitch has one
/// drop. Where drops would be more than 1.25 pitches apart, one more is placed if all are still at least
/// `least_mm` apart.
Polyline dropsAlong(const Polygon& outline, double pitch_mm, double least_mm);

/// Refuses regions of a layer that have room for more than 5 million drops.
/// @throws InvalidInput
void requireFewDrops(const Regions& regions, const DropSettings& settings);

/// Positions of the drops on one line of a raster, from left to right [raster frame].
using DropLine = std::function<std::vector<double>(std::int64_t line, double left, double right)>;

/// Places the drops of a layer in order, and leaves out those too close to one that was placed already.
class DropFill {
 public:
  /// @throws InvalidInput if diameter, pitch or line spacing are not positive or too small for the regions
  DropFill(const Regions& regions, const DropSettings& settings);

  /// Adds contours around the regions, from the outside: the first half a diameter inside the border, the
  /// next ones a line spacing further inside, until there are `most` or no further one fits. Each starts near
  /// the end of the one before. Contours along the border are outer walls, the others inner walls. Where the
  /// first contour would run back beside itself too closely for two rows, one row replaces both, as infill.
  void addContours(const Regions& regions, std::size_t most);

  /// Area inside the contours for the centres of further drops, a line spacing from the innermost contour.
  Regions inside(const Regions& regions, std::size_t contours) const;

  /// Adds lines of drops, to and fro, in runs that continue from line to line.
  void addLines(const Raster& raster, const RasterFrame& frame, const DropLine& line);

  std::vector<FillPath> take() && { return std::move(paths_); }

 private:
  /// Adds loops that are visible on the part's surface and so must not have a wide gap.
  void addLoops(const Regions& regions, PathRole role);
  void add(const Polyline& drops, PathRole role);
  Polyline startedNear(Polyline loop) const;

  DropSettings settings_;
  double least_distance_;
  PointGrid deposited_;
  std::vector<FillPath> paths_;
};

/// Fills a layer by drops: contours (`drops.contours`), then lines `row_mm` apart at the request's angle.
std::vector<FillPath> contoursAndLines(const Regions& regions, const InfillRequest& request, double row_mm,
                                       const DropLine& line);

}  // namespace lamina
