// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Closed outline [mm]: the last point joins the first, which is not repeated. Counter-clockwise encloses
/// material, clockwise encloses a hole.
using Polygon = std::vector<Point2>;

/// Open line through points [mm].
using Polyline = std::vector<Point2>;

/// One connected area: a counter-clockwise outline and the clockwise outlines of its holes.
struct Region {
  Polygon outer;
  std::vector<Polygon> holes;
};

using Regions = std::vector<Region>;

/// Area [mm²], positive counter-clockwise; 0 for fewer than three points.
double signedArea(const Polygon& polygon);

/// Sum of the signed areas [mm²]: with outlines wound as above, the area of material.
double signedArea(const std::vector<Polygon>& polygons);

/// Area of material [mm²].
double area(const Regions& regions);

/// Length of the closed outline [mm].
double perimeter(const Polygon& polygon);

/// Length of the open line [mm].
double length(const Polyline& line);

/// Bounding box of all points; empty if there are none.
Box2 boundingBox(const std::vector<Polygon>& polygons);

/// Whether the point lies inside the outline by the even-odd rule; for points on the outline the result is
/// undefined.
bool encloses(const Polygon& outline, const Point2& point);

/// Whether the point lies in material by the even-odd rule; for points on an outline the result is undefined.
bool contains(const std::vector<Polygon>& polygons, const Point2& point);

/// All outlines of the regions, outer ones and holes.
std::vector<Polygon> outlines(const Regions& regions);

}  // namespace lamina
