// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/spatial/edge_grid.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Limits of a combing path.
struct WayLimits {
  double longest_mm = 0.0;  ///< greatest length of the whole path
  double reach_mm = 0.0;    ///< greatest distance of an end outside the area from the area
};

/// The area of a layer to which travels are confined, and the shortest paths within it. A path bends at
/// reflex corners only, and is found by A* over these corners. A line between two corners is checked only
/// when it is the most promising one, against the edges in those cells of a grid that it crosses.
class CombArea {
 public:
  /// @param area  with outlines oriented as `unite` returns them
  explicit CombArea(const Regions& area);

  /// The shortest path between two points, both ends included. An end outside the area is joined to the
  /// nearest point of the area. None if the ends lie in different regions or too far outside, if the path is
  /// too long, or if the search exceeds 1000 corners.
  std::optional<Polyline> shortestWay(const Point2& from, const Point2& to, const WayLimits& limits) const;

 private:
  class Search;

  struct Edge {
    Point2 from;
    Point2 to;
    std::size_t region;
  };

  /// A corner round which paths can bend.
  struct Corner {
    Point2 at;
    Point2 before;
    Point2 after;
    Point2 inner;  ///< a point of the area close to it
  };

  /// An end of a path.
  struct End {
    Point2 at;  ///< within the area
    std::size_t region;
  };

  /// A corner by its x and its index in its region.
  using CornerByX = std::pair<double, std::size_t>;

  void addOutline(const Polygon& outline, std::size_t region);
  /// The region in which a point lies.
  std::optional<std::size_t> regionOf(const Point2& point) const;
  std::optional<End> endAt(const Point2& point, double reach_mm) const;
  bool isOpen(const Point2& a, const Point2& b) const;
  std::optional<Polyline> bendsBetween(const End& from, const End& to, double longest_mm) const;

  std::vector<Edge> edges_;
  EdgeGrid grid_;
  std::vector<std::vector<Corner>> corners_;  ///< of each region
  std::vector<std::vector<CornerByX>> by_x_;  ///< of each region, from left to right
};

}  // namespace lamina
