// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/inside.hpp"

#include <algorithm>

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
  if (!encloses(region.outer, point)) return false;
  return std::none_of(region.holes.begin(), region.holes.end(),
                      [&point](const Polygon& hole) { return encloses(hole, point); });
}

}  // namespace

bool staysInside(const Regions& regions, const Point2& from, const Point2& to) {
  const Point2 along = to - from;
  const double length = along.norm();
  if (length <= 2.0 * kEndTolerance) return true;
  const Point2 inset = kEndTolerance / length * along;
  const Line line{from + inset, to - inset};
  // No more than one region has the start of the line; it stays inside if that one's outlines do not cross
  // it.
  const auto around = std::find_if(regions.begin(), regions.end(),
                                   [&line](const Region& region) { return isInside(region, line.from); });
  if (around == regions.end() || line.isCrossedBy(around->outer)) return false;
  return std::none_of(around->holes.begin(), around->holes.end(),
                      [&line](const Polygon& hole) { return line.isCrossedBy(hole); });
}

}  // namespace lamina
