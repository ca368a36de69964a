// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/height_field/height_field.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

/// The factor's slope at a corner, by the difference of its neighbours [1/mm].
Point2 gradientAt(const HeightField& field, int column, int row) {
  const int left = std::max(column - 1, 0);
  const int right = std::min(column + 1, field.cells.columns);
  const int below = std::max(row - 1, 0);
  const int above = std::min(row + 1, field.cells.rows);
  const double cell = field.cells.cell_mm;
  return {(field.factor[field.corner(right, row)] - field.factor[field.corner(left, row)]) /
              ((right - left) * cell),
          (field.factor[field.corner(column, above)] - field.factor[field.corner(column, below)]) /
              ((above - below) * cell)};
}

void addCorner(const HeightField& field, const LayerBounds& bounds, int column, int row, LayerChart& chart) {
  const Point2 corner = field.cornerPoint(column, row);
  const Point2 slope = (bounds.cut() - field.base_mm) * gradientAt(field, column, row);
  const Point3 normal = Point3(-slope.x(), -slope.y(), 1.0).normalized();
  LayerSurface& surface = chart.surface;
  surface.middle.vertices.push_back(field.bent({corner.x(), corner.y(), bounds.cut()}));
  surface.tip.push_back(field.bent({corner.x(), corner.y(), bounds.top_mm}));
  surface.normal.push_back(normal);
  surface.height_mm.push_back(bounds.height() * field.factor[field.corner(column, row)] * normal.z());
  chart.parameterization.push_back(corner);
}

}  // namespace

double HeightField::factorAt(const Point2& plan) const {
  const auto along = [this](double position, double origin, int count) {
    return std::clamp((position - origin) / cells.cell_mm, 0.0, static_cast<double>(count));
  };
  const double x = along(plan.x(), cells.origin.x(), cells.columns);
  const double y = along(plan.y(), cells.origin.y(), cells.rows);
  const int column = std::min(static_cast<int>(x), cells.columns - 1);
  const int row = std::min(static_cast<int>(y), cells.rows - 1);
  const double u = x - column;
  const double v = y - row;
  const double low = factor[corner(column, row)];
  const double high = factor[corner(column + 1, row + 1)];
  if (v <= u) {
    const double right = factor[corner(column + 1, row)];
    return low + u * (right - low) + v * (high - right);
  }
  const double above = factor[corner(column, row + 1)];
  return low + v * (above - low) + u * (high - above);
}

Point3 HeightField::bent(const Point3& level) const {
  return {level.x(), level.y(), base_mm + (level.z() - base_mm) * factorAt(level.head<2>())};
}

Point3 HeightField::level(const Point3& bent) const {
  return {bent.x(), bent.y(), base_mm + (bent.z() - base_mm) / factorAt(bent.head<2>())};
}

Mesh levelled(Mesh mesh, const HeightField& field) {
  for (Point3& vertex : mesh.vertices) vertex = field.level(vertex);
  return mesh;
}

LayerChart bentLayer(const HeightField& field, const LayerBounds& bounds, const Box2& area) {
  LayerChart chart;
  if (area.isEmpty()) return chart;
  const HeightGrid& cells = field.cells;
  const auto index = [&cells](double position, double origin, int count) {
    return std::clamp(static_cast<int>(std::floor((position - origin) / cells.cell_mm)), 0, count - 1);
  };
  const int first_column = index(area.low.x() - 1e-3, cells.origin.x(), cells.columns);
  const int last_column = index(area.high.x() + 1e-3, cells.origin.x(), cells.columns);
  const int first_row = index(area.low.y() - 1e-3, cells.origin.y(), cells.rows);
  const int last_row = index(area.high.y() + 1e-3, cells.origin.y(), cells.rows);
  for (int row = first_row; row <= last_row + 1; ++row)
    for (int column = first_column; column <= last_column + 1; ++column)
      addCorner(field, bounds, column, row, chart);
  const auto width = static_cast<std::uint32_t>(last_column - first_column + 2);
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(last_row - first_row + 1); ++row)
    for (std::uint32_t column = 0; column + 1 < width; ++column) {
      const std::uint32_t low = row * width + column;
      chart.surface.middle.triangles.push_back({low, low + 1, low + width + 1});
      chart.surface.middle.triangles.push_back({low, low + width + 1, low + width});
    }
  return chart;
}

}  // namespace lamina
