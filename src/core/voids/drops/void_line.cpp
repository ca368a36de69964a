// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voids/drops/void_line.hpp"

#include <algorithm>
#include <numeric>

#include "lamina/geometry/spatial/point_grid.hpp"

namespace lamina {
namespace {

constexpr double kTie = 1e-9;   // of a diameter: rounding
constexpr double kStep = 1e-6;  // of a step: drops exactly a step apart hang together

PointGrid gridOf(const std::vector<VoidPoint>& points, double cell) {
  Box2 box;
  for (const VoidPoint& point : points) box.include(point.position);
  PointGrid grid(box, cell);
  for (const VoidPoint& point : points) grid.insert(point.position);
  return grid;
}

/// Farthest from the middle; the points are sorted, so that the first of equals is the one wanted.
std::uint32_t lineEnd(const std::vector<VoidPoint>& points, double tie) {
  Point2 middle = Point2::Zero();
  for (const VoidPoint& point : points) middle += point.position / static_cast<double>(points.size());
  std::uint32_t end = 0;
  double farthest = -1.0;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double distance = (points[i].position - middle).norm();
    if (distance <= farthest + tie) continue;
    farthest = distance;
    end = i;
  }
  return end;
}

}  // namespace

std::vector<std::vector<VoidPoint>> clusters(const std::vector<VoidPoint>& points, double step_mm) {
  const PointGrid grid = gridOf(points, step_mm);
  std::vector<std::size_t> group(points.size(), points.size());
  std::size_t count = 0;
  for (std::uint32_t first = 0; first < points.size(); ++first) {
    if (group[first] != points.size()) continue;
    std::vector<std::uint32_t> reached = {first};
    group[first] = count;
    while (!reached.empty()) {
      const std::uint32_t from = reached.back();
      reached.pop_back();
      grid.visitNear(points[from].position, (1.0 + kStep) * step_mm, [&](std::uint32_t i, double) {
        if (group[i] != points.size()) return;
        group[i] = count;
        reached.push_back(i);
      });
    }
    ++count;
  }
  std::vector<std::vector<VoidPoint>> found(count);
  for (std::size_t i = 0; i < points.size(); ++i) found[group[i]].push_back(points[i]);
  return found;
}

std::vector<VoidPoint> guideLine(const std::vector<VoidPoint>& points, double diameter_mm) {
  if (points.empty()) return {};
  PointGrid left = gridOf(points, diameter_mm);
  std::vector<VoidPoint> line;
  std::optional<std::uint32_t> next = lineEnd(points, kTie * diameter_mm);
  while (next) {
    line.push_back(points[*next]);
    left.remove(*next);
    next = left.nearest(line.back().position, kTie * diameter_mm);
  }
  return line;
}

}  // namespace lamina
