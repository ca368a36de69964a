// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/medial_axis/border_segments.hpp"

#include <algorithm>
#include <boost/polygon/segment_utils.hpp>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "geometry/polygon/outline_crossings.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kLargestMm = 20000.0;

void add(const Polygon& outline, BorderSegments& border) {
  std::vector<GridPoint> points;
  points.reserve(outline.size());
  for (const Point2& point : outline) {
    const Point2 at = (point - border.origin) * border.units_per_mm;
    points.emplace_back(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())));
  }
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
    if (points[j] != points[i]) border.segments.emplace_back(points[j], points[i]);
}

/// The segments cut where they meet.
std::vector<GridSegment> cut(const std::vector<GridSegment>& segments) {
  std::vector<std::pair<std::size_t, GridSegment>> pieces;
  boost::polygon::intersect_segments(pieces, segments.begin(), segments.end());
  std::vector<GridSegment> result;
  result.reserve(pieces.size());
  for (const auto& [whole, piece] : pieces) {
    const GridSegment& original = segments[whole];
    const auto along = [](const GridSegment& s) {
      return std::pair<double, double>(double(s.high().x()) - s.low().x(),
                                       double(s.high().y()) - s.low().y());
    };
    const auto [ax, ay] = along(original);
    const auto [bx, by] = along(piece);
    if (ax * bx + ay * by >= 0.0)
      result.push_back(piece);
    else
      result.emplace_back(piece.high(), piece.low());
  }
  return result;
}

std::tuple<GridPoint, GridPoint> undirected(const GridSegment& segment) {
  return std::minmax(segment.low(), segment.high());
}

/// Of segments on each other keeps one if more run one way than the other, none if as many.
std::vector<GridSegment> withoutPairs(std::vector<GridSegment> segments) {
  std::stable_sort(segments.begin(), segments.end(),
                   [](const GridSegment& a, const GridSegment& b) { return undirected(a) < undirected(b); });
  std::vector<GridSegment> result;
  for (std::size_t begin = 0, end = 0; begin < segments.size(); begin = end) {
    int forward = 0;
    while (end < segments.size() && undirected(segments[end]) == undirected(segments[begin]))
      forward += segments[end].low() < segments[end].high() ? 1 : -1, ++end;
    const auto [low, high] = undirected(segments[begin]);
    if (forward != 0) result.emplace_back(forward > 0 ? low : high, forward > 0 ? high : low);
  }
  return result;
}

}  // namespace

BorderSegments borderSegments(const Region& region) {
  const std::vector<Polygon> borders = outlines({region});
  const Box2 box = boundingBox(borders);
  BorderSegments border;
  if (box.isEmpty()) return border;
  if (!(box.size().maxCoeff() <= kLargestMm))
    throw InvalidInput("a region is " + std::to_string(box.size().maxCoeff()) +
                       " mm large; its medial axis needs at most 20 m");
  border.origin = box.centre();
  for (const Polygon& outline : borders) add(outline, border);
  if (!areSurelyApart(borders)) border.segments = cut(border.segments);
  border.segments = withoutPairs(std::move(border.segments));
  return border;
}

}  // namespace lamina
