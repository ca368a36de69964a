// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/pattern/pattern_fill.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// Of the spacing, across and in the area of a region.
constexpr double kMostSteps = 1e7;
constexpr double kMostSquares = 1e8;

std::vector<Polyline> fewestRuns(const std::vector<RunOnOutlines>& pieces,
                                 const std::vector<Polygon>& borders, double longest_mm) {
  std::vector<Polyline> runs = joinAlongOutlines(pieces, borders, longest_mm, LinkChoice::EveryOther);
  if (runs.size() < 2) return runs;
  std::vector<Polyline> others = joinAlongOutlines(pieces, borders, longest_mm, LinkChoice::ShortestFirst);
  return others.size() < runs.size() ? others : runs;
}

FillPath pathAlongLine(const Polyline& line) {
  FillPath path;
  for (const Point2& point : line)
    if (path.points.empty() || path.points.back() != point) path.points.push_back(point);
  return path;
}

}  // namespace

void requireSensibleSpacing(double spacing_mm, const Box2& box) {
  if (!(spacing_mm > 0.0 && std::isfinite(spacing_mm)))
    throw InvalidInput("infill spacing is " + numberText(spacing_mm) + " mm; must be positive");
  if (box.isEmpty()) return;
  const Point2 reach = box.high.cwiseAbs().cwiseMax(box.low.cwiseAbs()) / spacing_mm;
  const Point2 steps = box.size() / spacing_mm;
  if (!(reach.maxCoeff() <= kMostSteps && steps.prod() <= kMostSquares))
    throw InvalidInput("infill spacing is " + numberText(spacing_mm) + " mm; too small for a region " +
                       numberText(box.size().maxCoeff()) + " mm across");
}

double patternAngle(const InfillRequest& request) { return request.angle_rad - request.turn_rad; }

std::vector<FillPath> filledByPattern(const Regions& regions, const InfillRequest& request, double step_mm,
                                      const Pattern& pattern) {
  const std::vector<Polygon> borders = outlines(offset(regions, -0.5 * request.pitch_mm));
  const Box2 box = boundingBox(borders);
  requireSensibleSpacing(request.spacing_mm, box);
  if (box.isEmpty()) return {};
  const PatternPieces pieces = cutToOutlines(pattern(box), borders);
  std::vector<FillPath> paths;
  const double longest_mm = longestLink(request, step_mm) * step_mm;
  for (const Polyline& run : fewestRuns(pieces.open, borders, longest_mm))
    paths.push_back(pathAlongLine(run));
  for (const Polygon& loop : pieces.closed) {
    paths.push_back(pathAlongLine(loop));
    paths.back().is_closed = true;
  }
  return paths;
}

}  // namespace lamina
