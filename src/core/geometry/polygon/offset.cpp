// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/polygon/offset.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <polyclipping/clipper.hpp>
#include <string>
#include <utility>

#include "geometry/polygon/edge_collapse_inset.hpp"
#include "geometry/polygon/nesting.hpp"
#include "geometry/polygon/outline_crossings.hpp"
#include "geometry/polygon/raw_offset.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kUnitsPerMm = 1e5;
/// Within this, Clipper stays with 64-bit integers.
constexpr double kFarthestMm = 10000.0;
constexpr double kMitreLimit = 2.0;
constexpr double kArcToleranceUnits = 0.005 * kUnitsPerMm;

void refuseFarPoints(const Polygon& polygon) {
  for (const Point2& point : polygon)
    if (!(point.cwiseAbs().maxCoeff() <= kFarthestMm))
      throw InvalidInput("outline point (" + std::to_string(point.x()) + ", " + std::to_string(point.y()) +
                         ") mm; must be within 10 m of the origin");
}

void refuseFarPoints(const Regions& regions) {
  for (const Region& region : regions) {
    refuseFarPoints(region.outer);
    for (const Polygon& hole : region.holes) refuseFarPoints(hole);
  }
}

ClipperLib::Path toUnits(const Polygon& polygon) {
  ClipperLib::Path path;
  path.reserve(polygon.size());
  for (const Point2& point : polygon)
    path.emplace_back(std::llround(point.x() * kUnitsPerMm), std::llround(point.y() * kUnitsPerMm));
  return path;
}

Polygon fromUnits(const ClipperLib::Path& path) {
  Polygon polygon;
  polygon.reserve(path.size());
  for (const ClipperLib::IntPoint& point : path)
    polygon.emplace_back(static_cast<double>(point.X) / kUnitsPerMm,
                         static_cast<double>(point.Y) / kUnitsPerMm);
  return polygon;
}

/// Clipper's tree alternates outer outlines and holes level by level.
Regions fromTree(const ClipperLib::PolyTree& tree) {
  Regions regions;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
    if (node->IsHole()) continue;
    Region region;
    region.outer = fromUnits(node->Contour);
    region.holes.reserve(node->Childs.size());
    for (const ClipperLib::PolyNode* hole : node->Childs) region.holes.push_back(fromUnits(hole->Contour));
    regions.push_back(std::move(region));
  }
  return regions;
}

void add(ClipperLib::Clipper& clipper, const Regions& regions, ClipperLib::PolyType type) {
  for (const Region& region : regions) {
    clipper.AddPath(toUnits(region.outer), type, true);
    for (const Polygon& hole : region.holes) clipper.AddPath(toUnits(hole), type, true);
  }
}

Regions combine(const Regions& a, const Regions& b, ClipperLib::ClipType operation) {
  refuseFarPoints(a);
  refuseFarPoints(b);
  ClipperLib::Clipper clipper;
  add(clipper, a, ClipperLib::ptSubject);
  add(clipper, b, ClipperLib::ptClip);
  ClipperLib::PolyTree tree;
  clipper.Execute(operation, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return fromTree(tree);
}

Regions offsetRound(const Regions& regions, double delta_mm) {
  ClipperLib::ClipperOffset offsetter(kMitreLimit, kArcToleranceUnits);
  for (const Region& region : regions) {
    offsetter.AddPath(toUnits(region.outer), ClipperLib::jtRound, ClipperLib::etClosedPolygon);
    for (const Polygon& hole : region.holes)
      offsetter.AddPath(toUnits(hole), ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  }
  ClipperLib::PolyTree tree;
  offsetter.Execute(tree, delta_mm * kUnitsPerMm);
  return fromTree(tree);
}

Regions offsetMitred(const Regions& regions, double delta_mm) {
  ClipperLib::Clipper clipper;
  const auto addMoved = [&](const Polygon& outline) {
    if (outline.size() > 2)
      clipper.AddPath(toUnits(rawOffset(outline, delta_mm)), ClipperLib::ptSubject, true);
  };
  for (const Region& region : regions) {
    addMoved(region.outer);
    for (const Polygon& hole : region.holes) addMoved(hole);
  }
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftPositive, ClipperLib::pftPositive);
  return fromTree(tree);
}

/// Regions that shrink do not meet, so that each can be shrunk by itself.
Regions insetEach(const Regions& regions, double distance_mm) {
  Regions result;
  for (const Region& region : regions) {
    if (std::optional<Region> shrunk = insetByEdgeCollapse(region, distance_mm)) {
      result.push_back(std::move(*shrunk));
    } else {
      Regions clipped = offsetMitred({region}, -distance_mm);
      std::move(clipped.begin(), clipped.end(), std::back_inserter(result));
    }
  }
  return result;
}

}  // namespace

Regions unite(const std::vector<Polygon>& polygons) {
  for (const Polygon& polygon : polygons) refuseFarPoints(polygon);
  if (areSurelyApart(polygons)) {
    if (std::optional<Regions> nested = nest(polygons)) return std::move(*nested);
  }
  ClipperLib::Clipper clipper;
  for (const Polygon& polygon : polygons) clipper.AddPath(toUnits(polygon), ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return fromTree(tree);
}

Regions offset(const Regions& regions, double delta_mm, Join join) {
  refuseFarPoints(regions);
  if (join == Join::Round) return offsetRound(regions, delta_mm);
  return delta_mm < 0.0 ? insetEach(regions, -delta_mm) : offsetMitred(regions, delta_mm);
}

std::vector<Polyline> clipped(const std::vector<Polyline>& lines, const Regions& regions) {
  refuseFarPoints(regions);
  ClipperLib::Clipper clipper;
  for (const Polyline& line : lines) {
    refuseFarPoints(line);
    clipper.AddPath(toUnits(line), ClipperLib::ptSubject, false);
  }
  add(clipper, regions, ClipperLib::ptClip);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctIntersection, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  ClipperLib::Paths found;
  ClipperLib::OpenPathsFromPolyTree(tree, found);
  std::vector<Polyline> pieces;
  pieces.reserve(found.size());
  for (const ClipperLib::Path& path : found) pieces.push_back(fromUnits(path));
  return pieces;
}

Regions difference(const Regions& regions, const Regions& subtracted) {
  return combine(regions, subtracted, ClipperLib::ctDifference);
}

Regions intersection(const Regions& a, const Regions& b) { return combine(a, b, ClipperLib::ctIntersection); }

}  // namespace lamina
