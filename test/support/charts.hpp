// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

#include "lamina/parameterization/layer_surface.hpp"

namespace lamina::test {

constexpr double kChartHeight = 0.2;  // mm, of the layers

/// Two triangles in each cell of a grid of vertices, `columns` + 1 of them to a row.
inline void addGrid(Mesh& mesh, std::uint32_t columns, std::uint32_t rows) {
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t corner = (columns + 1) * j + i;
      mesh.triangles.push_back({corner, corner + 1, corner + columns + 2});
      mesh.triangles.push_back({corner, corner + columns + 2, corner + columns + 1});
    }
}

inline void addVertex(LayerChart& chart, const Point3& middle, const Point3& normal,
                      const Point2& parameters) {
  chart.surface.middle.vertices.push_back(middle);
  chart.surface.normal.push_back(normal);
  chart.surface.tip.emplace_back(middle + 0.5 * kChartHeight * normal);
  chart.surface.height_mm.push_back(kChartHeight);
  chart.parameterization.push_back(parameters);
}

/// A square of that side from the origin at z = 0, of cells x cells squares; its parameterization is itself.
inline LayerChart levelChart(double side, std::uint32_t cells) {
  LayerChart chart;
  for (std::uint32_t j = 0; j <= cells; ++j)
    for (std::uint32_t i = 0; i <= cells; ++i) {
      const Point2 plan(side * i / cells, side * j / cells);
      addVertex(chart, {plan.x(), plan.y(), 0.0}, Point3::UnitZ(), plan);
    }
  addGrid(chart.surface.middle, cells, cells);
  return chart;
}

/// Half a cylinder about the y axis, above z = 0, of a polygon of that many sides whose corners lie on the
/// circle; its plan is its development, from (0, 0).
inline LayerChart halfCylinder(double radius, double length, std::uint32_t sides) {
  LayerChart chart;
  const double side = 2.0 * radius * std::sin(0.5 * M_PI / sides);
  for (std::uint32_t j = 0; j <= 10; ++j)
    for (std::uint32_t i = 0; i <= sides; ++i) {
      const double angle = M_PI * i / sides;
      const Point3 normal(-std::cos(angle), 0.0, std::sin(angle));
      addVertex(chart, radius * normal + Point3(0.0, 0.1 * length * j, 0.0), normal,
                {side * i, 0.1 * length * j});
    }
  addGrid(chart.surface.middle, sides, 10);
  return chart;
}

/// The cap of a sphere around its top down to that angle from the axis. Its plan is polar: distances from the
/// top along the sphere are kept.
inline LayerChart polarCap(double radius, double angle, std::uint32_t rings, std::uint32_t around) {
  LayerChart chart;
  addVertex(chart, {0.0, 0.0, radius}, Point3::UnitZ(), Point2::Zero());
  for (std::uint32_t j = 1; j <= rings; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const double down = angle * j / rings;
      const Point2 heading(std::cos(2.0 * M_PI * i / around), std::sin(2.0 * M_PI * i / around));
      const Point3 normal(std::sin(down) * heading.x(), std::sin(down) * heading.y(), std::cos(down));
      addVertex(chart, radius * normal, normal, radius * down * heading);
    }
  const auto at = [around](std::uint32_t j, std::uint32_t i) { return 1 + (j - 1) * around + i % around; };
  std::vector<Triangle>& triangles = chart.surface.middle.triangles;
  for (std::uint32_t i = 0; i < around; ++i) {
    triangles.push_back({0, at(1, i), at(1, i + 1)});
    for (std::uint32_t j = 1; j < rings; ++j) {
      triangles.push_back({at(j, i), at(j + 1, i), at(j + 1, i + 1)});
      triangles.push_back({at(j, i), at(j + 1, i + 1), at(j, i + 1)});
    }
  }
  return chart;
}

/// The chart and its plan at another place of the plane.
inline LayerChart moved(LayerChart chart, const Point2& by) {
  const Point3 in_space(by.x(), by.y(), 0.0);
  for (Point3& vertex : chart.surface.middle.vertices) vertex += in_space;
  for (Point3& tip : chart.surface.tip) tip += in_space;
  for (Point2& point : chart.parameterization) point += by;
  return chart;
}

}  // namespace lamina::test
