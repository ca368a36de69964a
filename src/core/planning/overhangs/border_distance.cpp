// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/overhangs/border_distance.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr double kFewestCells = 32.0;       // across
constexpr double kMostCells = 1024.0;       // across
constexpr double kAsideOfCorners = 0.0137;  // cells: middles of cells lie on no corner of usual parts

}  // namespace

BorderDistance::BorderDistance(const Regions& regions, double reach_mm) : reach_(reach_mm) {
  const std::vector<Polygon> borders = outlines(regions);
  for (const Polygon& border : borders)
    for (std::size_t i = 0, j = border.size() - 1; i < border.size(); j = i++)
      edges_.emplace_back(border[j], border[i]);
  const Box2 box = boundingBox(borders);
  if (box.isEmpty()) return;
  const double across = std::clamp(2.0 * std::sqrt(double(edges_.size())), kFewestCells, kMostCells);
  const double cell_mm = std::max(reach_, box.size().maxCoeff() / across);
  box_ = {box.low.array() - reach_ - kAsideOfCorners * cell_mm, box.high.array() + reach_};
  grid_ = EdgeGrid(edges_, box_, cell_mm);
  findInside();
}

/// Row by row, from crossing to crossing of the line through the middles.
void BorderDistance::findInside() {
  std::vector<std::vector<double>> crossings(grid_.rows());
  for (const auto& [a, b] : edges_) {
    const auto [low, high] = std::minmax(a.y(), b.y());
    for (std::size_t row = grid_.rowOf(low); row <= grid_.rowOf(high); ++row) {
      const double y = grid_.centreOf(0, row).y();
      if ((a.y() > y) == (b.y() > y)) continue;
      crossings[row].push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }
  is_inside_.assign(grid_.rows() * grid_.columns(), false);
  for (std::size_t row = 0; row < grid_.rows(); ++row) {
    std::vector<double>& line = crossings[row];
    std::sort(line.begin(), line.end());
    std::size_t passed = 0;
    for (std::size_t column = 0; column < grid_.columns(); ++column) {
      const double x = grid_.centreOf(column, row).x();
      while (passed < line.size() && line[passed] < x) ++passed;
      is_inside_[row * grid_.columns() + column] = passed % 2 == 1;
    }
  }
}

bool BorderDistance::isInside(const Point2& point) const {
  if (edges_.empty() || (point.array() < box_.low.array()).any() || (point.array() > box_.high.array()).any())
    return false;
  const std::size_t column = grid_.columnOf(point.x());
  const std::size_t row = grid_.rowOf(point.y());
  bool is_inside = is_inside_[row * grid_.columns() + column];
  const Point2 middle = grid_.centreOf(column, row);
  grid_.forEdgesIn(column, row, [&](std::size_t e) {
    if (areCrossing(point, middle, edges_[e].first, edges_[e].second)) is_inside = !is_inside;
    return true;
  });
  return is_inside;
}

double BorderDistance::at(const Point2& point) const {
  if (edges_.empty()) return reach_;
  double nearest = reach_ * reach_;
  const Point2 reach(reach_, reach_);
  visitEdges(point - reach, point + reach, [&](const Point2& a, const Point2& b) {
    nearest = std::min(nearest, (nearestOnSegment(a, b, point) - point).squaredNorm());
  });
  return isInside(point) ? -std::sqrt(nearest) : std::sqrt(nearest);
}

}  // namespace lamina
