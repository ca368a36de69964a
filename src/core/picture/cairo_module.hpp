// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lamina/picture/canvas.hpp"

namespace lamina {

/// A raster of pixels to draw on; all coordinates are in pixels, y downwards.
class PixelSurface {
 public:
  virtual ~PixelSurface() = default;
  virtual void line(const std::vector<Point2>& points, const Stroke& stroke) = 0;
  virtual void area(const std::vector<Point2>& corners, const Colour& colour) = 0;
  virtual void rectangle(const Box2& box, const Colour& colour) = 0;
  virtual void dot(const Point2& centre, double radius, const Colour& colour) = 0;
  /// @param corner  upper left corner of the raster
  /// @param cell    width and height of a cell
  virtual void raster(const Point2& corner, const Point2& cell, const CellColours& cells) = 0;
  virtual void text(const Point2& at, const std::string& text, const TextStyle& style) = 0;
  virtual std::vector<std::uint8_t> rgb() const = 0;  ///< as in `PixelImage`
  virtual std::string png() const = 0;
};

/// Functions of the module `cairo`, which keeps cairo and its fonts out of commands that draw nothing.
struct CairoModule {
  std::unique_ptr<PixelSurface> (*surface)(int width, int height);  ///< makes a white surface
};

}  // namespace lamina
