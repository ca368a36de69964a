// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/inside.hpp"

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr double kEndTolerance = 1e-4;  // mm

struct Line {
  Point2 from;
  Point2 to;

  bool isCrossedBy(const Point2& a, const Point2& b) const { return areCrossing(from, to, a, b); }

  bool isCrossedBy(const Polygon& outline) const {
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
      if (isCrossedBy(outline[j], outline[i])) return true;
    return false;
  }
};

bool isInside(const Region& region, const Point2& point) {
  bool is_inside = encloses(region.outer, point);
  for (const Polygon& hole : region.holes) is_inside = is_inside && !encloses(hole, point);
  return is_inside;
}

}  // namespace

bool staysInside(const Regions& regions, const Point2& from, const Point2& to) {
  const Point2 along = to - from;
  const double length = along.norm();
  if (length <= 2.0 * kEndTolerance) return true;
  const Point2 inset = kEndTolerance / length * along;
  const Line line{from + inset, to - inset};
  bool is_inside = false;
  for (const Region& region : regions) {
    if (line.isCrossedBy(region.outer)) return false;
    for (const Polygon& hole : region.holes)
      if (line.isCrossedBy(hole)) return false;
    is_inside = is_inside || isInside(region, line.from);
  }
  return is_inside;
}

}  // namespace lamina
