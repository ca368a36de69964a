// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/height_field/top_surface.hpp"

#include <algorithm>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// In cells, or parts of a triangle: what rounding leaves at the border of a part.
constexpr double kRounding = 1e-9;

using Corners = std::array<Point3, 3>;

class Raster {
 public:
  Raster(const HeightGrid& cells, double base_mm) : cells_(cells), base_mm_(base_mm) {
    top_.at_corner.resize(static_cast<std::size_t>(cells.columns + 1) *
                          static_cast<std::size_t>(cells.rows + 1));
    top_.over_half.resize(2 * cells.cellCount());
  }

  TopSurface take(const Mesh& mesh) && {
    forUpwardTriangles(mesh, [this](const Corners& triangle) { addToCorners(triangle); });
    top_.prolonged = top_.at_corner;
    prolong();
    prolong();
    for (std::optional<double>& height : top_.prolonged)
      if (height && !(*height > 0.0)) height.reset();
    forUpwardTriangles(mesh, [this](const Corners& triangle) { addToHalves(triangle); });
    return std::move(top_);
  }

 private:
  /// With heights above the bed.
  template <class Visit>
  void forUpwardTriangles(const Mesh& mesh, const Visit& visit) const {
    const double least_area = kRounding * cells_.cell_mm * cells_.cell_mm;
    for (const Triangle& triangle : mesh.triangles) {
      Corners corners;
      for (std::size_t i = 0; i < 3; ++i)
        corners[i] = mesh.vertices[triangle[i]] - Point3(0.0, 0.0, base_mm_);
      if (cross((corners[1] - corners[0]).head<2>(), (corners[2] - corners[0]).head<2>()) > least_area)
        visit(corners);
    }
  }

  struct Span {
    int first = 0;
    int last = 0;
  };

  Span columnsOf(const Corners& triangle, double margin) const {
    const auto [low, high] = std::minmax({triangle[0].x(), triangle[1].x(), triangle[2].x()});
    return {static_cast<int>(std::floor((low - cells_.origin.x()) / cells_.cell_mm - margin)),
            static_cast<int>(std::floor((high - cells_.origin.x()) / cells_.cell_mm + margin))};
  }
  Span rowsOf(const Corners& triangle, double margin) const {
    const auto [low, high] = std::minmax({triangle[0].y(), triangle[1].y(), triangle[2].y()});
    return {static_cast<int>(std::floor((low - cells_.origin.y()) / cells_.cell_mm - margin)),
            static_cast<int>(std::floor((high - cells_.origin.y()) / cells_.cell_mm + margin))};
  }

  void addToCorners(const Corners& triangle) {
    const Span columns = columnsOf(triangle, kRounding);
    const Span rows = rowsOf(triangle, kRounding);
    for (int row = std::max(rows.first, 0); row <= std::min(rows.last, cells_.rows); ++row)
      for (int column = std::max(columns.first, 0); column <= std::min(columns.last, cells_.columns);
           ++column)
        addToCorner(triangle, column, row);
  }

  void addToCorner(const Corners& triangle, int column, int row) {
    const Point2 place = cells_.origin + cells_.cell_mm * Point2(column, row) - triangle[2].head<2>();
    const Point2 a = (triangle[0] - triangle[2]).head<2>();
    const Point2 b = (triangle[1] - triangle[2]).head<2>();
    const double area = cross(a, b);
    const double first = cross(place, b) / area;
    const double second = cross(a, place) / area;
    const double third = 1.0 - first - second;
    if (std::min({first, second, third}) < -kRounding) return;
    const double height = first * triangle[0].z() + second * triangle[1].z() + third * triangle[2].z();
    std::optional<double>& highest = top_.at_corner[cornerOf(cells_, column, row)];
    highest = highest ? std::max(*highest, height) : height;
  }

  /// In line with the two corners further in, the mean over the directions of the axes.
  std::optional<double> inLine(const std::vector<std::optional<double>>& known, int column, int row) const {
    constexpr std::array<std::array<int, 2>, 4> kDirections = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    double sum = 0.0;
    int count = 0;
    for (const auto& [x, y] : kDirections) {
      const int c = column + 2 * x;
      const int r = row + 2 * y;
      if (c < 0 || r < 0 || c > cells_.columns || r > cells_.rows) continue;
      const std::optional<double>& near = known[cornerOf(cells_, column + x, row + y)];
      const std::optional<double>& far = known[cornerOf(cells_, c, r)];
      if (!near || !far) continue;
      sum += 2.0 * *near - *far;
      ++count;
    }
    if (count == 0) return std::nullopt;
    return sum / count;
  }

  void prolong() {
    const std::vector<std::optional<double>> known = top_.prolonged;
    for (int row = 0; row <= cells_.rows; ++row)
      for (int column = 0; column <= cells_.columns; ++column)
        if (!known[cornerOf(cells_, column, row)])
          top_.prolonged[cornerOf(cells_, column, row)] = inLine(known, column, row);
  }

  void addToHalves(const Corners& triangle) {
    const Span columns = columnsOf(triangle, -kRounding);
    const Span rows = rowsOf(triangle, -kRounding);
    for (int row = std::max(rows.first, 0); row <= std::min(rows.last, cells_.rows - 1); ++row)
      for (int column = std::max(columns.first, 0); column <= std::min(columns.last, cells_.columns - 1);
           ++column) {
        addToHalf(triangle, 2 * cells_.cell(column, row));
        addToHalf(triangle, 2 * cells_.cell(column, row) + 1);
      }
  }

  /// Lifts what is linear between the heights at the corners above the triangle's corners, and so above the
  /// whole triangle.
  void addToHalf(const Corners& triangle, std::size_t half) {
    std::optional<std::array<double, 3>>& over = top_.over_half[half];
    if (!over) over = heightsAt(half);
    const Point2 low = cells_.origin + cells_.cell_mm * Point2(cells_.column(half / 2), cells_.row(half / 2));
    double lack = 0.0;
    for (const Point3& point : triangle) {
      const Point2 place = (point.head<2>() - low) / cells_.cell_mm;
      const double first = half % 2 == 0 ? place.x() : place.y();
      const double second = half % 2 == 0 ? place.y() : place.x();
      const std::array<double, 3>& h = *over;
      lack = std::max(lack, point.z() - (h[0] + first * (h[1] - h[0]) + second * (h[2] - h[1])));
    }
    for (double& height : *over) height += lack;
  }

  /// Of the prolonged surface; zero if it does not reach all corners.
  std::array<double, 3> heightsAt(std::size_t half) const {
    std::array<double, 3> heights{};
    const std::array<std::size_t, 3> corners = cornersOfHalf(cells_, half);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!top_.prolonged[corners[i]]) return {0.0, 0.0, 0.0};
      heights[i] = *top_.prolonged[corners[i]];
    }
    return heights;
  }

  const HeightGrid& cells_;
  double base_mm_;
  TopSurface top_;
};

}  // namespace

TopSurface topSurface(const Mesh& mesh, const HeightGrid& cells, double base_mm) {
  return Raster(cells, base_mm).take(mesh);
}

}  // namespace lamina
