// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voids/beads/void_classifier.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr double kSharpCorner = M_PI / 3.0;
constexpr double kCornerReach = 2.0;  // pitches

/// Whether material is within less than the sharp angle there.
bool isSharp(const Point2& before, const Point2& at, const Point2& after) {
  const Point2 in = (at - before).normalized();
  const Point2 out = (after - at).normalized();
  return turn(in, out) > M_PI - kSharpCorner;
}

double distanceTo(const Polygon& outline, const Point2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Point2 along = outline[i] - outline[j];
    const double squared = along.squaredNorm();
    const double t = squared > 0.0 ? std::clamp((point - outline[j]).dot(along) / squared, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (outline[j] + t * along - point).norm());
  }
  return nearest;
}

bool isInfill(const Path& path) { return path.role == PathRole::Infill || path.role == PathRole::GapFill; }

}  // namespace

VoidClassifier::VoidClassifier(const Regions& contour, const ToolpathLayer& layer, const ScanRows& rows,
                               const std::vector<std::vector<BeadSpan>>& reaches)
    : layer_(layer), rows_(rows), reaches_(reaches), contour_(outlines(contour)) {
  for (const Polygon& outline : contour_)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point2& before = outline[i == 0 ? outline.size() - 1 : i - 1];
      const Point2& after = outline[i + 1 == outline.size() ? 0 : i + 1];
      if (isSharp(before, outline[i], after)) sharp_corners_.push_back(outline[i]);
    }
}

/// Those that reach the points beside the corners of its outlines.
std::vector<std::uint32_t> VoidClassifier::runsAround(const Region& area) const {
  std::vector<std::uint32_t> runs;
  const double step = 1.5 * rows_.spacing_mm;
  const auto addReaching = [&](const Point2& at) {
    const std::size_t row = rows_.firstAbove(at.y() - 0.5 * rows_.spacing_mm);
    if (row >= rows_.count) return;
    for (const BeadSpan& span : reaches_[row])
      if (span.low <= at.x() && at.x() <= span.high) runs.push_back(span.run);
  };
  for (const Polygon& outline : outlines({area}))
    for (const Point2& corner : outline)
      for (const Point2& aside : {Point2(step, 0), Point2(-step, 0), Point2(0, step), Point2(0, -step)})
        addReaching(corner + aside);
  std::sort(runs.begin(), runs.end());
  runs.erase(std::unique(runs.begin(), runs.end()), runs.end());
  return runs;
}

bool VoidClassifier::liesInSharpCorner(const Polygon& outline, double reach_mm) const {
  return std::any_of(sharp_corners_.begin(), sharp_corners_.end(), [&](const Point2& corner) {
    return encloses(outline, corner) || distanceTo(outline, corner) <= reach_mm;
  });
}

bool VoidClassifier::goesRound(std::uint32_t run, const Point2& point) const {
  const Path& path = layer_.paths[run];
  if (!path.is_closed) return false;
  Polygon loop;
  loop.reserve(path.points.size());
  for (const Point3& each : path.points) loop.emplace_back(each.head<2>());
  return encloses(loop, point);
}

bool VoidClassifier::touchesContour(const Polygon& outline) const {
  return std::any_of(outline.begin(), outline.end(), [&](const Point2& corner) {
    return std::any_of(contour_.begin(), contour_.end(), [&](const Polygon& border) {
      return distanceTo(border, corner) < 2.0 * rows_.spacing_mm;
    });
  });
}

VoidClass VoidClassifier::classOf(const Region& area, double pitch_mm) const {
  const Polygon& outline = area.outer;
  if (outline.empty()) return VoidClass::Between;
  if (liesInSharpCorner(outline, kCornerReach * pitch_mm)) return VoidClass::Corner;
  bool touches_infill = false;
  std::size_t around = 0;
  std::size_t beside = 0;
  for (const std::uint32_t run : runsAround(area)) {
    if (isInfill(layer_.paths[run]))
      touches_infill = true;
    else
      ++(goesRound(run, outline.front()) ? around : beside);
  }
  if (touches_infill)
    return around + beside > 0 || touchesContour(outline) ? VoidClass::RasterBorder : VoidClass::Between;
  if (around > 0 && beside > 0) return VoidClass::Meeting;
  return around == 1 && beside == 0 ? VoidClass::Core : VoidClass::ShapeChange;
}

}  // namespace lamina
