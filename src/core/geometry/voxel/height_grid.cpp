// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/height_grid.hpp"

#include <algorithm>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

double cellsAlong(double side_mm, double cell_mm) {
  return std::max(1.0, std::ceil(side_mm / cell_mm - 1e-9));
}

double cellCountOf(const Point2& size, double cell_mm) {
  return cellsAlong(size.x(), cell_mm) * cellsAlong(size.y(), cell_mm);
}

double smallestFittingCell(const Point2& size, double cell_mm) {
  const double most = static_cast<double>(HeightGrid::kMostCells);
  double fitting = std::max(cell_mm, std::sqrt(size.x() * size.y() / most));
  while (cellCountOf(size, fitting) > most) fitting *= 1.01;
  return fitting;
}

}  // namespace

HeightGrid heightGrid(const Box2& area, double cell_mm) {
  if (!(cell_mm > 0.0 && std::isfinite(cell_mm)))
    throw InvalidInput("cell size of the height map is " + numberText(cell_mm) + " mm; must be positive");
  if (area.isEmpty() || !area.low.allFinite() || !area.high.allFinite())
    throw InvalidInput("area of the height map is empty or not finite; a rectangle of the bed is needed");
  const Point2 size = area.size();
  if (!size.allFinite()) throw InvalidInput("area of the height map is too large to be measured");
  if (cellCountOf(size, cell_mm) > static_cast<double>(HeightGrid::kMostCells))
    throw InvalidInput("height map of " + numberText(size.x()) + " x " + numberText(size.y()) +
                       " mm with cells of " + numberText(cell_mm) + " mm has more than " +
                       std::to_string(HeightGrid::kMostCells) + " cells; a cell size of " +
                       numberText(smallestFittingCell(size, cell_mm)) + " mm fits");
  return {area.low, cell_mm, static_cast<int>(cellsAlong(size.x(), cell_mm)),
          static_cast<int>(cellsAlong(size.y(), cell_mm))};
}

}  // namespace lamina
