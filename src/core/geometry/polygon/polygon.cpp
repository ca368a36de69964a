// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {
namespace {

bool crossesRayFrom(const Point2& point, const Point2& a, const Point2& b) {
  if ((a.y() > point.y()) == (b.y() > point.y())) return false;
  return point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y());
}

}  // namespace

double signedArea(const Polygon& polygon) {
  if (polygon.size() < 3) return 0.0;
  const Point2& origin = polygon.front();
  double two_areas = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Point2 a = polygon[i] - origin;
    const Point2 b = polygon[i + 1] - origin;
    two_areas += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * two_areas;
}

double signedArea(const std::vector<Polygon>& polygons) {
  double sum = 0.0;
  for (const Polygon& polygon : polygons) sum += signedArea(polygon);
  return sum;
}

double area(const Regions& regions) { return signedArea(outlines(regions)); }

double perimeter(const Polygon& polygon) {
  if (polygon.empty()) return 0.0;
  return length(polygon) + (polygon.front() - polygon.back()).norm();
}

double length(const Polyline& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

Box2 boundingBox(const std::vector<Polygon>& polygons) {
  Box2 box;
  for (const Polygon& polygon : polygons)
    for (const Point2& point : polygon) box.include(point);
  return box;
}

bool encloses(const Polygon& outline, const Point2& point) {
  bool is_inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
    if (crossesRayFrom(point, outline[j], outline[i])) is_inside = !is_inside;
  return is_inside;
}

bool contains(const std::vector<Polygon>& polygons, const Point2& point) {
  bool is_inside = false;
  for (const Polygon& polygon : polygons) is_inside = is_inside != encloses(polygon, point);
  return is_inside;
}

std::vector<Polygon> outlines(const Regions& regions) {
  std::vector<Polygon> all;
  for (const Region& region : regions) {
    all.push_back(region.outer);
    all.insert(all.end(), region.holes.begin(), region.holes.end());
  }
  return all;
}

}  // namespace lamina
