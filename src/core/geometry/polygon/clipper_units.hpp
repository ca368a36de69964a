// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <polyclipping/clipper.hpp>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

inline constexpr double kUnitsPerMm = 1e5;
/// Greatest coordinate for which Clipper computes with 64-bit integers.
inline constexpr double kFarthestMm = 10000.0;

/// Refuses points beyond that coordinate.
/// @throws InvalidInput
inline void requireWithinReach(const Polygon& polygon) {
  for (const Point2& point : polygon)
    if (!(point.cwiseAbs().maxCoeff() <= kFarthestMm))
      throw InvalidInput("outline point (" + numberText(point.x()) + ", " + numberText(point.y()) +
                         ") mm; must be within 10 m of the origin");
}

/// The polygon in the integer units of Clipper.
inline ClipperLib::Path toUnits(const Polygon& polygon) {
  ClipperLib::Path path;
  path.reserve(polygon.size());
  for (const Point2& point : polygon)
    path.emplace_back(std::llround(point.x() * kUnitsPerMm), std::llround(point.y() * kUnitsPerMm));
  return path;
}

inline Polygon fromUnits(const ClipperLib::Path& path) {
  Polygon polygon;
  polygon.reserve(path.size());
  for (const ClipperLib::IntPoint& point : path)
    polygon.emplace_back(static_cast<double>(point.X) / kUnitsPerMm,
                         static_cast<double>(point.Y) / kUnitsPerMm);
  return polygon;
}

/// The regions of Clipper's tree, in which outer outlines and holes alternate level by level.
inline Regions fromTree(const ClipperLib::PolyTree& tree) {
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

}  // namespace lamina
