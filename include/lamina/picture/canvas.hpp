// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/picture/colour.hpp"
#include "lamina/picture/pixel_image.hpp"

namespace lamina {

enum class TextAnchor { Left, Centre, Right };
enum class TextWeight { Normal, Bold };

struct TextStyle {
  double size_px = 15.0;
  Colour colour{0.15, 0.16, 0.18};
  TextAnchor anchor = TextAnchor::Left;
  TextWeight weight = TextWeight::Normal;
};

/// Stroke of a line.
struct Stroke {
  Colour colour;
  double width_px = 1.0;
  double dash_px = 0.0;  ///< length of dashes and gaps; 0 for a full line
};

/// One colour per cell, row by row, the first row at the bottom of the extent.
struct CellColours {
  int columns = 0;
  int rows = 0;
  std::vector<Colour> cells;  ///< columns times rows
};

class PixelSurface;

/// A white picture in pixels, x to the right and y down from its top left corner, that shows a piece of a
/// plane in mm, x to the right and y up. Lines are anti-aliased, with round ends and joins.
class Canvas {
 public:
  /// @throws InvalidInput if a side is not within 16 and 16384 pixels
  Canvas(int width_px, int height_px);
  ~Canvas();

  int width() const { return width_px_; }
  int height() const { return height_px_; }

  /// Shows `world` [mm] as large as it fits into `area` [px], centred, at the same scale in x and y.
  /// An empty world is shown as 1 mm around the origin.
  void show(const Box2& world, const Box2& area);
  double pixelsPerMm() const { return pixels_per_mm_; }
  /// Position on the picture of a point [mm].
  Point2 toPixels(const Point2& point) const;

  /// A line through points [mm].
  void line(const std::vector<Point2>& points, const Stroke& stroke);
  /// A line through points [px].
  void linePx(const std::vector<Point2>& points, const Stroke& stroke);
  /// A filled polygon [mm].
  void area(const std::vector<Point2>& corners, const Colour& colour);
  /// A filled rectangle [px].
  void rectanglePx(const Box2& box, const Colour& colour);
  /// A filled disc [mm], with its radius on the picture.
  void dot(const Point2& centre, double radius_px, const Colour& colour);
  /// A filled disc [px].
  void dotPx(const Point2& centre, double radius_px, const Colour& colour);
  /// Cells of even colour over an extent [mm].
  void raster(const Box2& extent, const CellColours& cells);
  /// @param at  position of the anchor on the base line [px]
  void text(const Point2& at, const std::string& text, const TextStyle& style);

  PixelImage pixels() const;
  /// The picture as the bytes of a PNG file.
  std::string png() const;
  /// Writes the picture as a PNG file, which appears whole or not at all.
  /// @throws FileError if it cannot be written
  void writePng(const std::string& path) const;

 private:
  int width_px_;
  int height_px_;
  double pixels_per_mm_ = 1.0;
  Point2 origin_px_ = Point2::Zero();  ///< where (0, 0) mm is
  std::unique_ptr<PixelSurface> surface_;
};

}  // namespace lamina
