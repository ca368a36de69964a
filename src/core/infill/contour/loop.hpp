// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A place on a loop.
struct LoopPlace {
  double position_mm = 0.0;  ///< along the loop, from its first point
  double distance_mm = 0.0;  ///< of what was asked for
};

/// A stretch of a loop around a place.
struct LoopStretch {
  double middle_mm = 0.0;
  double reach_mm = 0.0;  ///< to either side
};

/// A closed line measured by arc length. Positions along it [mm] may be any number: they go round.
class Loop {
 public:
  /// @param points    at least three, no two neighbours the same
  /// @param width_mm  plan width on the way to each point
  Loop(Polygon points, std::vector<double> width_mm);

  double length() const { return at_.back(); }
  const Box2& box() const { return box_; }
  const Polygon& points() const { return points_; }
  /// Within [0, length).
  double wrapped(double position) const;
  Point2 pointAt(double position) const;
  double widthAt(double position) const;

  /// The nearest place to a point.
  LoopPlace nearest(const Point2& point) const;
  /// The nearest place to a point on a stretch.
  LoopPlace nearest(const Point2& point, const LoopStretch& stretch) const;
  /// Where a ray first hits a stretch; the distance along it, which has unit length.
  std::optional<LoopPlace> hit(const Point2& from, const Point2& direction, const LoopStretch& stretch) const;
  /// Whether the open line from one point to the other crosses the loop, touching at its ends left aside.
  bool isCrossedBy(const Point2& from, const Point2& to) const;

  /// Index of the point at or before a position within [0, length).
  std::size_t edgeAt(double position) const;
  double positionOf(std::size_t point) const { return at_[point]; }
  /// Plan width on the edge that starts at that point.
  double edgeWidth(std::size_t point) const { return width_[point + 1 < points_.size() ? point + 1 : 0]; }
  std::size_t size() const { return points_.size(); }

 private:
  const Point2& endOf(std::size_t edge) const { return points_[edge + 1 < points_.size() ? edge + 1 : 0]; }
  template <class Visit>
  void visitEdges(const LoopStretch& stretch, const Visit& visit) const;

  Polygon points_;
  std::vector<double> width_;
  std::vector<double> at_;  ///< of each point, and the length
  Box2 box_;
};

}  // namespace lamina
