// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A plane turned so that the lines of a raster are along x, with line number 0 at y = 0.
class RasterFrame {
 public:
  /// @param bottom_mm  y in the turned plane at which the frame has its y = 0
  explicit RasterFrame(double angle_rad, double bottom_mm = 0.0);
  Point2 intoRaster(const Point2& point) const;
  Point2 outOfRaster(const Point2& point) const;

 private:
  double cos_;
  double sin_;
  double bottom_;
};

/// The bounding box of a box, in the raster frame.
Box2 boxInRaster(const Box2& box, const RasterFrame& frame);

/// A point at which an outline crosses a raster line.
struct Crossing {
  std::int64_t line = 0;  ///< the line y = line * spacing
  double x = 0.0;         ///< on that line [mm, raster frame]
  std::uint32_t outline = 0;
  std::uint32_t edge = 0;  ///< index of the outline's point at which the edge starts
};

/// Outlines cut by the lines y = k * spacing of the raster frame.
struct Raster {
  double spacing_mm = 0.0;
  std::vector<Polygon> outlines;  ///< in the raster frame
  /// Crossings in the order in which they are met along the outlines, one outline after the other. A point on
  /// a line counts as above it, so that each line has an even number of crossings.
  std::vector<Crossing> crossings;
  /// Indices of crossings, line by line from below, on each line from left to right. Numbers 2i and 2i+1 are
  /// the ends of a segment inside.
  std::vector<std::uint32_t> sorted;
  std::int64_t lowest = 0;  ///< number of the lowest line that has crossings
  std::vector<std::uint32_t>
      /// For each line from the lowest on, where it begins in `sorted`; and the end of the last one.
      line_begin;
};

/// Cuts regions by raster lines.
/// @throws InvalidInput if the spacing is not positive, or so small that a line would have a number above 10
///   million
Raster rasterise(const Regions& regions, double spacing_mm, const RasterFrame& frame);

}  // namespace lamina
