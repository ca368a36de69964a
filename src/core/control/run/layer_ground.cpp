// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run/layer_ground.hpp"

#include <algorithm>
#include <limits>

#include "geometry/boxes.hpp"

namespace lamina {

double widestBead(const LayerCells& cells) {
  return cells.size() == 0 ? 0.0 : *std::max_element(cells.width_mm.begin(), cells.width_mm.end());
}

std::optional<std::size_t> cellAt(const LayerCells& cells, const PrintPosition& place) {
  const auto run = std::lower_bound(cells.runs.begin(), cells.runs.end(), place.path,
                                    [](const CellRun& each, std::size_t path) { return each.path < path; });
  if (run == cells.runs.end() || run->path != place.path) return std::nullopt;
  const auto cell = static_cast<std::size_t>(std::max(0.0, place.along_mm / run->cellLength()));
  return run->first + std::min(cell, run->count - 1);
}

double highestCell(const std::vector<CellEstimate>& estimates) {
  double highest = -1e9;
  for (const CellEstimate& cell : estimates)
    if (cell.isKnown()) highest = std::max(highest, -cell.error());
  return highest;
}

Box3 groundOf(const LayerCells& cells, const Eigen::Vector3d& normal) {
  Box3 ground;
  const double reach = widestBead(cells);
  const Point3 around(reach, reach, reach);
  for (const Point3& middle : cells.middle) {
    const Point3 at = middle - middle.dot(normal) * normal;
    ground.include(at - around);
    ground.include(at + around);
  }
  return ground;
}

std::vector<double> heightsOver(double level_mm, const Box3& ground, const Eigen::Vector3d& normal,
                                const std::vector<Point3>& points,
                                const Eigen::Isometry3d& toolpath_from_sensor) {
  std::vector<double> heights;
  heights.reserve(points.size());
  for (const Point3& point : points) {
    const Point3 at = toolpath_from_sensor * point;
    const double height = at.dot(normal);
    const bool is_point = point.allFinite() && !point.isZero(0.0);
    const bool is_over = is_point && isInBox(ground, Point3(at - height * normal));
    heights.push_back(is_over ? height - level_mm : std::numeric_limits<double>::quiet_NaN());
  }
  return heights;
}

}  // namespace lamina
