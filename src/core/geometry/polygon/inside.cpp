// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/inside.hpp"

#include <algorithm>
#include <optional>

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

constexpr double kBoxMargin = 1e-6;  // mm; far above rounding

/// Without the tolerance at its ends.
std::optional<Line> shortened(const Point2& from, const Point2& to) {
  const Point2 along = to - from;
  const double length = along.norm();
  if (length <= 2.0 * kEndTolerance) return std::nullopt;
  const Point2 inset = kEndTolerance / length * along;
  return Line{from + inset, to - inset};
}

Box2 boxRound(const Polygon& outline) {
  Box2 box;
  for (const Point2& point : outline) box.include(point);
  return {box.low - Point2::Constant(kBoxMargin), box.high + Point2::Constant(kBoxMargin)};
}

bool holds(const Box2& box, const Point2& point) {
  return (point.array() >= box.low.array()).all() && (point.array() <= box.high.array()).all();
}

bool isWithin(const Region& around, const Line& line) {
  if (line.isCrossedBy(around.outer)) return false;
  return std::none_of(around.holes.begin(), around.holes.end(),
                      [&line](const Polygon& hole) { return line.isCrossedBy(hole); });
}

}  // namespace

// No more than one region has the start of a line; the line stays inside if that one's outlines do not cross
// it.

bool staysInside(const Regions& regions, const Point2& from, const Point2& to) {
  const std::optional<Line> line = shortened(from, to);
  if (!line) return true;
  const auto around = std::find_if(regions.begin(), regions.end(),
                                   [&line](const Region& region) { return isInside(region, line->from); });
  return around != regions.end() && isWithin(*around, *line);
}

InsideTest::InsideTest(const Regions& regions) : regions_(regions) {
  boxes_.reserve(regions.size());
  for (const Region& region : regions) {
    Boxes& boxes = boxes_.emplace_back();
    boxes.outer = boxRound(region.outer);
    boxes.holes.reserve(region.holes.size());
    for (const Polygon& hole : region.holes) boxes.holes.push_back(boxRound(hole));
  }
}

bool InsideTest::isInside(std::size_t region, const Point2& point) const {
  if (!holds(boxes_[region].outer, point) || !encloses(regions_[region].outer, point)) return false;
  const std::vector<Polygon>& holes = regions_[region].holes;
  for (std::size_t i = 0; i < holes.size(); ++i)
    if (holds(boxes_[region].holes[i], point) && encloses(holes[i], point)) return false;
  return true;
}

bool InsideTest::staysInside(const Point2& from, const Point2& to) const {
  const std::optional<Line> line = shortened(from, to);
  if (!line) return true;
  std::size_t around = 0;
  while (around < regions_.size() && !isInside(around, line->from)) ++around;
  if (around == regions_.size() || line->isCrossedBy(regions_[around].outer)) return false;
  const Point2 low = from.cwiseMin(to);
  const Point2 high = from.cwiseMax(to);
  const std::vector<Polygon>& holes = regions_[around].holes;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const Box2& box = boxes_[around].holes[i];
    const bool is_beside = (high.array() < box.low.array()).any() || (low.array() > box.high.array()).any();
    if (!is_beside && line->isCrossedBy(holes[i])) return false;
  }
  return true;
}

}  // namespace lamina
