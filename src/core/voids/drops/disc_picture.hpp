// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"
#include "lamina/voids/beads/void_points.hpp"

namespace lamina {

/// Square pixels over a part of the plane.
class PixelWindow {
 public:
  /// @param pixel_mm  positive; larger where there would be more than `most` of them
  PixelWindow(const Box2& box, double pixel_mm, double most);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double pixelArea() const { return pixel_ * pixel_; }
  std::uint8_t& at(int column, int row) { return values_[index(column, row)]; }
  std::uint8_t at(int column, int row) const { return values_[index(column, row)]; }
  /// Indices of the pixel that holds the point, within the window.
  int column(double x) const { return clamped((x - low_.x()) / pixel_, columns_); }
  int row(double y) const { return clamped((y - low_.y()) / pixel_, rows_); }

  /// Sets pixels whose centres lie in the disc from one value to another.
  void paintDisc(const Point2& centre, double radius, std::uint8_t from, std::uint8_t to);
  /// Sets pixels whose centres lie inside the outlines by the even-odd rule.
  void paintInside(const std::vector<Polygon>& outlines, std::uint8_t value);
  /// Sets the pixels of the value that hang together with this one by their sides to another value.
  /// @return how many
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

/// A drop's disc drawn for measuring: a little larger, so that drops that touch leave no way through.
inline constexpr double kDrawnRadius = 0.5 * (1.0 + 1e-3);  // diameters
/// Size of a pixel: below a 50th, and no part of a lattice's pitch, so that no row of drops hides between
/// pixels.
inline constexpr double kPixel = 1.0 / 53.0;  // diameters

/// No pixel is smaller than this part of a void's greatest clearance: drops so small beside a void fill
/// little.
inline constexpr double kVoidPixel = 1.0 / 100.0;

/// What drops leave uncovered of a void.
struct UncoveredArea {
  double before_mm2 = 0.0;
  double after_mm2 = 0.0;
};

/// The drops of a layer as discs.
class DiscPicture {
 public:
  DiscPicture(const std::vector<Point2>& prior, const std::vector<Point2>& added, double diameter_mm,
              const std::vector<Polygon>& borders);

  /// Uncovered material within the clearance of the points that hangs together with one of them.
  UncoveredArea around(const std::vector<VoidPoint>& points) const;

 private:
  static PointGrid gridOf(const std::vector<Point2>& points, double cell);

  PointGrid prior_;
  PointGrid added_;
  double diameter_;
  const std::vector<Polygon>& borders_;
};

}  // namespace lamina
