// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scaffold/convex_clip.hpp"

#include <algorithm>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// Fractions of a segment between which it is inside; none if low >= high.
struct Inside {
  double low = 0.0;
  double high = 1.0;
};

Inside insidePart(const Point2& from, const Point2& to, const Polygon& outline) {
  Inside part;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point2 edge = outline[i + 1 < outline.size() ? i + 1 : 0] - outline[i];
    const double at_from = cross(edge, from - outline[i]);  // positive inside
    const double at_to = cross(edge, to - outline[i]);
    if (at_from < 0.0 && at_to < 0.0) return {1.0, 0.0};
    if (at_from < 0.0) part.low = std::max(part.low, at_from / (at_from - at_to));
    if (at_to < 0.0) part.high = std::min(part.high, at_from / (at_from - at_to));
  }
  return part;
}

}  // namespace

std::vector<Polyline> clippedToConvex(const Polyline& line, const Polygon& outline) {
  std::vector<Polyline> pieces;
  bool goes_on = false;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point2& from = line[i - 1];
    const Point2 way = line[i] - from;
    const Inside part = insidePart(from, line[i], outline);
    if (part.low >= part.high) {
      goes_on = false;
      continue;
    }
    if (!goes_on || part.low > 0.0) pieces.push_back({Point2(from + part.low * way)});
    pieces.back().push_back(from + part.high * way);
    goes_on = part.high >= 1.0;
  }
  return pieces;
}

}  // namespace lamina
