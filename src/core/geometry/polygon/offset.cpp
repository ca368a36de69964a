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

#include "geometry/polygon/clipper_units.hpp"
#include "geometry/polygon/crossed_outlines.hpp"
#include "geometry/polygon/edge_collapse_inset.hpp"
#include "geometry/polygon/nesting.hpp"
#include "geometry/polygon/outline_crossings.hpp"
#include "geometry/polygon/path_nesting.hpp"
#include "geometry/polygon/plane_vectors.hpp"
#include "geometry/polygon/raw_offset.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kMitreLimit = 2.0;
constexpr double kArcToleranceUnits = 0.005 * kUnitsPerMm;

void refuseFarPoints(const Regions& regions) {
  for (const Region& region : regions) {
    requireWithinReach(region.outer);
    for (const Polygon& hole : region.holes) requireWithinReach(hole);
  }
}

void add(ClipperLib::Clipper& clipper, const Regions& regions, ClipperLib::PolyType type) {
  for (const Region& region : regions) {
    clipper.AddPath(toUnits(region.outer), type, true);
    for (const Polygon& hole : region.holes) clipper.AddPath(toUnits(hole), type, true);
  }
}

Regions combine(const Regions& a, const Regions& b, ClipperLib::ClipType operation) {
  ClipperLib::Clipper clipper;
  add(clipper, a, ClipperLib::ptSubject);
  add(clipper, b, ClipperLib::ptClip);
  return executed(clipper, operation, ClipperLib::pftNonZero);
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

std::vector<Polygon> movedOutlines(const Regions& regions, double delta_mm) {
  std::vector<Polygon> moved;
  const auto addMoved = [&](const Polygon& outline) {
    if (outline.size() > 2) moved.push_back(rawOffset(outline, delta_mm));
  };
  for (const Region& region : regions) {
    addMoved(region.outer);
    for (const Polygon& hole : region.holes) addMoved(hole);
  }
  return moved;
}

Regions offsetMitred(const Regions& regions, double delta_mm) {
  const std::vector<Polygon> moved = movedOutlines(regions, delta_mm);
  if (delta_mm > 0.0 && areSurelyApart(moved)) {
    if (std::optional<Regions> nested = nest(moved)) return std::move(*nested);
  }
  ClipperLib::Clipper clipper;
  for (const Polygon& outline : moved) clipper.AddPath(toUnits(outline), ClipperLib::ptSubject, true);
  return executed(clipper, ClipperLib::ctUnion, ClipperLib::pftPositive);
}

/// Narrower than its corners are rounded. Outlines that double back in a shrinking needle leave such ones, on
/// the outline that they should keep away from.
bool isSliver(const Region& region) {
  constexpr double kNarrowest = 2.0 / kUnitsPerMm;
  return signedArea(region.outer) < kNarrowest * perimeter(region.outer);
}

/// Whether no disc of that diameter fits: the whole lies between two lines that near to each other. Nothing
/// is said of what is bent.
bool isStripBelow(const Polygon& outline, double width_mm) {
  if (outline.size() < 3) return true;
  Point2 along = Point2::Zero();
  for (const Point2& point : outline)
    if ((point - outline.front()).squaredNorm() > along.squaredNorm()) along = point - outline.front();
  double least = 0.0, greatest = 0.0;
  for (const Point2& point : outline) {
    const double aside = cross(along, point - outline.front());
    least = std::min(least, aside);
    greatest = std::max(greatest, aside);
  }
  return greatest - least < width_mm * along.norm();
}

/// Regions that shrink do not meet, so that each can be shrunk by itself.
Regions insetEach(const Regions& regions, double distance_mm) {
  Regions result;
  for (const Region& region : regions) {
    if (isStripBelow(region.outer, 2.0 * distance_mm)) continue;
    if (std::optional<Region> shrunk = insetByEdgeCollapse(region, distance_mm)) {
      result.push_back(std::move(*shrunk));
    } else {
      for (Region& left : offsetMitred({region}, -distance_mm))
        if (!isSliver(left)) result.push_back(std::move(left));
    }
  }
  return result;
}

}  // namespace

Regions unite(const std::vector<Polygon>& polygons) {
  for (const Polygon& polygon : polygons) requireWithinReach(polygon);
  if (areSurelyApart(polygons)) {
    if (std::optional<Regions> nested = nest(polygons)) return std::move(*nested);
  }
  ClipperLib::Clipper clipper;
  for (const Polygon& polygon : polygons) clipper.AddPath(toUnits(polygon), ClipperLib::ptSubject, true);
  return executed(clipper, ClipperLib::ctUnion, ClipperLib::pftNonZero);
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
    requireWithinReach(line);
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
  refuseFarPoints(regions);
  refuseFarPoints(subtracted);
  if (std::optional<Regions> rest = CrossedOutlines(regions, subtracted).rest()) return std::move(*rest);
  return combine(regions, subtracted, ClipperLib::ctDifference);
}

Regions intersection(const Regions& a, const Regions& b) {
  refuseFarPoints(a);
  refuseFarPoints(b);
  if (std::optional<Regions> common = CrossedOutlines(a, b).common()) return std::move(*common);
  return combine(a, b, ClipperLib::ctIntersection);
}

}  // namespace lamina
