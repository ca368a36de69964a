// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/polygon/region_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "geometry/polygon/plane_vectors.hpp"
#include "geometry/polygon/point_diagram.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"

namespace lamina {
namespace {

/// Delaunay triangles of points in the plane, counter-clockwise; of points on one circle any that fit.
/// @param points  no two the same within a billionth of their extent
std::vector<Triangle> delaunayTriangles(const std::vector<Point2>& points) {
  PointDiagram diagram;
  construct(diagram, points);
  std::vector<Triangle> triangles;
  triangles.reserve(diagram.num_vertices());
  for (const auto& vertex : diagram.vertices()) {
    const std::vector<std::size_t> around = pointsAround(vertex);
    for (std::size_t i = 1; i + 1 < around.size(); ++i) {
      Triangle corner{static_cast<std::uint32_t>(around[0]), static_cast<std::uint32_t>(around[i]),
                      static_cast<std::uint32_t>(around[i + 1])};
      const double twice =
          cross(points[corner[1]] - points[corner[0]], points[corner[2]] - points[corner[0]]);
      if (twice < 0.0) std::swap(corner[1], corner[2]);
      triangles.push_back(corner);
    }
  }
  return triangles;
}

constexpr int kMostDivisions = 10;
constexpr double kSamePoint = 1e-6;  // mm: a billionth of a metre
constexpr double kClearance =
    0.75;  // of a step between points inside and the border: they hide none of its edges

/// A piece of an outline between two points of the border.
struct BorderEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
};

struct Border {
  std::vector<Point2> points;
  std::vector<OutlinePlace> places;
  std::vector<BorderEdge> edges;
};

std::uint64_t keyOf(std::uint32_t from, std::uint32_t to) {
  return (static_cast<std::uint64_t>(from) << 32U) | to;
}

/// The points of an outline without those that are given several times in a row, and without spikes, which go
/// out and back along a line. Of points at one place the last is left: it begins the next edge.
std::vector<std::uint32_t> cornersOf(const Polygon& outline) {
  std::deque<std::uint32_t> corners;
  // Of the corner that is `from` places before the end.
  const auto at = [&](std::size_t from) { return outline[corners[corners.size() - from]]; };
  const auto isSame = [](const Point2& a, const Point2& b) { return (b - a).norm() <= kSamePoint; };
  const auto fold = [&] {
    for (std::size_t before = 1; before <= 2 && before < corners.size(); ++before)
      if (isSame(at(before + 1), at(1))) {
        corners.erase(corners.end() - static_cast<std::ptrdiff_t>(before + 1), corners.end() - 1);
        return true;
      }
    return false;
  };
  const auto add = [&](std::uint32_t corner) {
    corners.push_back(corner);
    while (fold()) continue;
  };
  for (std::uint32_t i = 0; i < outline.size(); ++i) add(i);
  // Twice around, so that what the outline begins with follows on what it ends with.
  for (std::size_t left = corners.size(); left > 0 && corners.size() >= 3; --left) {
    add(corners.front());
    corners.pop_front();
  }
  return {corners.begin(), corners.end()};
}

Border borderOf(const std::vector<Polygon>& outlines) {
  Border border;
  for (std::size_t o = 0; o < outlines.size(); ++o) {
    const std::vector<std::uint32_t> corners = cornersOf(outlines[o]);
    const auto count = static_cast<std::uint32_t>(corners.size());
    if (count < 3)
      throw InvalidInput("outline " + std::to_string(o) + " has " + std::to_string(count) +
                         " points; expected three or more");
    const auto first = static_cast<std::uint32_t>(border.points.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      border.points.push_back(outlines[o][corners[i]]);
      border.places.push_back({o, corners[i], 0.0});
      border.edges.push_back({first + i, first + (i + 1) % count});
    }
  }
  return border;
}

/// A lattice of equilateral triangles over the border's box, away from the border. What lies outside is
/// sorted out with its triangles.
std::vector<Point2> latticePoints(const Border& border, double step_mm) {
  const Box2 box = boundingBox({border.points});
  PointGrid grid(box, step_mm);
  for (const Point2& point : border.points) grid.insert(point);
  std::vector<Point2> points;
  const double row_mm = step_mm * std::sqrt(0.75);
  const auto rows = static_cast<std::size_t>(box.size().y() / row_mm);
  const auto columns = static_cast<std::size_t>(box.size().x() / step_mm);
  for (std::size_t r = 0; r <= rows; ++r) {
    for (std::size_t c = 0; c <= columns; ++c) {
      const double x = static_cast<double>(c) + (r % 2 == 0 ? 0.25 : 0.75);
      const Point2 point = box.low + Point2(x * step_mm, (static_cast<double>(r) + 0.5) * row_mm);
      if (!grid.hasNearer(point, kClearance * step_mm)) points.push_back(point);
    }
  }
  return points;
}

/// Which triangle has an edge on its left.
std::unordered_map<std::uint64_t, std::uint32_t> edgesOf(const std::vector<Triangle>& triangles) {
  std::unordered_map<std::uint64_t, std::uint32_t> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) edges.emplace(keyOf(triangles[t][k], triangles[t][(k + 1) % 3]), t);
  return edges;
}

/// Divides an edge in the middle; its second half is appended.
void divide(Border& border, std::size_t edge) {
  const BorderEdge whole = border.edges[edge];
  const OutlinePlace& from = border.places[whole.from];
  const OutlinePlace& to = border.places[whole.to];
  const bool is_within = to.segment == from.segment && to.fraction > from.fraction;
  const double end = is_within ? to.fraction : 1.0;
  const OutlinePlace middle{from.outline, from.segment, 0.5 * (from.fraction + end)};
  const auto added = static_cast<std::uint32_t>(border.points.size());
  border.points.emplace_back(0.5 * (border.points[whole.from] + border.points[whole.to]));
  border.places.push_back(middle);
  border.edges[edge].to = added;
  border.edges.push_back({added, whole.to});
}

void divideLong(Border& border, double step_mm) {
  for (std::size_t e = 0; e < border.edges.size(); ++e)
    while ((border.points[border.edges[e].to] - border.points[border.edges[e].from]).norm() > step_mm)
      divide(border, e);
}

/// Triangles that are reached from the left of the border without crossing it.
std::vector<Triangle> insideOf(const std::vector<Triangle>& triangles, const std::vector<BorderEdge>& border,
                               const std::unordered_map<std::uint64_t, std::uint32_t>& edges) {
  std::unordered_set<std::uint64_t> walls;
  std::vector<bool> is_inside(triangles.size(), false);
  std::vector<std::uint32_t> open;
  const auto enter = [&](std::uint32_t triangle) {
    if (!is_inside[triangle]) open.push_back(triangle);
    is_inside[triangle] = true;
  };
  for (const BorderEdge& edge : border) {
    walls.insert(keyOf(edge.from, edge.to));
    enter(edges.at(keyOf(edge.from, edge.to)));
  }
  while (!open.empty()) {
    const Triangle corner = triangles[open.back()];
    open.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = corner[k];
      const std::uint32_t to = corner[(k + 1) % 3];
      const auto across = edges.find(keyOf(to, from));
      if (across != edges.end() && walls.count(keyOf(from, to)) == 0) enter(across->second);
    }
  }
  std::vector<Triangle> inside;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (is_inside[t]) inside.push_back(triangles[t]);
  return inside;
}

/// Without the points that no triangle uses; those of the border stay.
RegionTriangulation compacted(const Border& border, const std::vector<Point2>& points,
                              const std::vector<Triangle>& triangles) {
  RegionTriangulation result;
  result.points = border.points;
  result.border = border.places;
  constexpr std::uint32_t kUnused = 0xFFFFFFFFU;
  std::vector<std::uint32_t> number(points.size(), kUnused);
  for (std::uint32_t i = 0; i < border.points.size(); ++i) number[i] = i;
  for (Triangle corner : triangles) {
    for (std::uint32_t& v : corner) {
      if (number[v] == kUnused) {
        number[v] = static_cast<std::uint32_t>(result.points.size());
        result.points.push_back(points[v]);
      }
      v = number[v];
    }
    result.triangles.push_back(corner);
  }
  return result;
}

}  // namespace

RegionTriangulation triangulated(const std::vector<Polygon>& outlines, double step_mm) {
  Border border = borderOf(outlines);
  divideLong(border, step_mm);
  const std::vector<Point2> lattice = latticePoints(border, step_mm);
  for (int round = 0; round <= kMostDivisions; ++round) {
    std::vector<Point2> points = border.points;
    points.insert(points.end(), lattice.begin(), lattice.end());
    const std::vector<Triangle> triangles = delaunayTriangles(points);
    const auto edges = edgesOf(triangles);
    const std::size_t before = border.edges.size();
    for (std::size_t e = 0; e < before; ++e)
      if (edges.count(keyOf(border.edges[e].from, border.edges[e].to)) == 0) divide(border, e);
    if (border.edges.size() == before)
      return compacted(border, points, insideOf(triangles, border.edges, edges));
  }
  throw InvalidInput("an outline could not be made edges of a triangulation in " +
                     std::to_string(kMostDivisions) +
                     " divisions; expected outlines that cross neither themselves nor each other");
}

}  // namespace lamina
