// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {

/// What a piece of a medial axis is nearest to: an edge of the border or a corner.
struct ArcSite {
  Point2 from;
  Point2 to;  ///< `from` again for a corner
  bool is_segment = false;

  /// From the line through a segment, positive on its left; from a corner, never negative.
  double signedDistanceTo(const Point2& point) const;
  double distanceTo(const Point2& point) const;
};

/// The points as far from one site as from another: a line, or a parabola if they are an edge and a corner.
struct AxisArc {
  ArcSite first;
  ArcSite second;

  /// From one point of the arc to another; in between point and radius are within the tolerance of linear.
  /// Any unit of length.
  std::vector<AxisPoint> sampled(const Point2& from, const Point2& to, double tolerance) const;
};

}  // namespace lamina
