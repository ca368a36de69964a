// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"
#include "lamina/voids/beads/void_points.hpp"

namespace lamina {

/// A raster of square pixels over a rectangle of the plane.
class PixelWindow {
 public:
  /// @param pixel_mm  positive; enlarged if there would be more than `most` pixels
  PixelWindow(const Box2& box, double pixel_mm, double most);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double pixelArea() const { return pixel_ * pixel_; }
  std::uint8_t& at(int column, int row) { return values_[index(column, row)]; }
  std::uint8_t at(int column, int row) const { return values_[index(column, row)]; }
  /// Column (or row) of the pixel that contains a point; clamped to the window.
  int column(double x) const { return clamped((x - low_.x()) / pixel_, columns_); }
  int row(double y) const { return clamped((y - low_.y()) / pixel_, rows_); }

  /// Changes those pixels with value `from` whose centres are in the disc to value `to`.
  void paintDisc(const Point2& centre, double radius, std::uint8_t from, std::uint8_t to);
  /// Sets those pixels whose centres are inside the outlines by the even-odd rule.
  void paintInside(const std::vector<Polygon>& outlines, std::uint8_t value);
  /// Changes the pixels that have the value of this one and are connected to it by their sides to another
  /// value.
  /// @return their number
  std::size_t flood(int column, int row, std::uint8_t to);
  std::size_t count(std::uint8_t value) const;

 private:
  static int clamped(double position, int count);
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  Point2 low_;
  double pixel_;
  int columns_;
  int rows_;
  std::vector<std::uint8_t> values_;
};

/// Radius with which a drop's disc is drawn: slightly enlarged, so that there is no gap between drops that
/// touch.
inline constexpr double kDrawnRadius = 0.5 * (1.0 + 1e-3);  // diameters
/// Size of a pixel: below a 50th of the diameter, and no fraction of a lattice's pitch, so that no row of
/// drops falls between pixels.
inline constexpr double kPixel = 1.0 / 53.0;  // diameters

/// Least size of a pixel as a share of a void's greatest clearance. Drops that are so small beside a void
/// fill little of it.
inline constexpr double kVoidPixel = 1.0 / 100.0;

/// Area of a void that drops do not cover.
struct UncoveredArea {
  double before_mm2 = 0.0;
  double after_mm2 = 0.0;
};

/// The drops of a layer as discs.
class DiscPicture {
 public:
  DiscPicture(const std::vector<Point2>& prior, const std::vector<Point2>& added, double diameter_mm,
              const std::vector<Polygon>& borders);

  /// Area not covered within the clearance of the given points, as far as it is connected to one of them.
  UncoveredArea around(const std::vector<VoidPoint>& points) const;

 private:
  static PointGrid gridOf(const std::vector<Point2>& points, double cell);

  PointGrid prior_;
  PointGrid added_;
  double diameter_;
  const std::vector<Polygon>& borders_;
};

}  // namespace lamina
