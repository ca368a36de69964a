// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A plane turned so that the lines of a raster lie along x, and the line of number 0 at y = 0.
class RasterFrame {
 public:
  /// @param bottom_mm  where y = 0 lies in the turned plane
  explicit RasterFrame(double angle_rad, double bottom_mm = 0.0);
  Point2 intoRaster(const Point2& point) const;
  Point2 outOfRaster(const Point2& point) const;

 private:
  double cos_;
  double sin_;
  double bottom_;
};

/// Round the box, in the raster frame.
Box2 boxInRaster(const Box2& box, const RasterFrame& frame);

/// Where an outline crosses a raster line.
struct Crossing {
  std::int64_t line = 0;  ///< the line y = line * spacing
  double x = 0.0;         ///< on that line [mm, raster frame]
  std::uint32_t outline = 0;
  std::uint32_t edge = 0;  ///< starts at the outline's point of that index
};

/// Outlines cut by the lines y = k * spacing of the raster frame.
struct Raster {
  double spacing_mm = 0.0;
  std::vector<Polygon> outlines;  ///< in the raster frame
  /// In the order met when walking along the outlines, one outline after the other. A point on a line counts
  /// as above it, so that the crossings of each line come in pairs.
  std::vector<Crossing> crossings;
  /// Indices of crossings, line by line from below, on each line from left to right: 2i and 2i+1 bound a line
  /// inside.
  std::vector<std::uint32_t> sorted;
  std::int64_t lowest = 0;  ///< line that has crossings
  std::vector<std::uint32_t>
      line_begin;  ///< where lines from the lowest on begin among the sorted, and an end
};

/// @throws InvalidInput if the spacing is not positive, or so small that a line would have a number above 10
/// million
Raster rasterise(const Regions& regions, double spacing_mm, const RasterFrame& frame);

}  // namespace lamina
