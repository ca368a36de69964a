// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/raster.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kMostLines = 1e7;

Polygon turned(const Polygon& polygon, const RasterFrame& frame) {
  Polygon result;
  result.reserve(polygon.size());
  for (const Point2& point : polygon) result.push_back(frame.intoRaster(point));
  return result;
}

void refuseTooManyLines(const Box2& box, double spacing) {
  if (!box.isEmpty() && box.high.cwiseAbs().cwiseMax(box.low.cwiseAbs()).y() > kMostLines * spacing)
    throw InvalidInput("infill spacing is " + numberText(spacing) + " mm; too small for a region " +
                       numberText(box.size().y()) + " mm across");
}

/// The first line at or above y.
std::int64_t firstLineFrom(double y, double spacing) {
  return static_cast<std::int64_t>(std::ceil(y / spacing));
}

class EdgeCutter {
 public:
  EdgeCutter(Raster& raster, double spacing) : raster_(raster), spacing_(spacing) {}

  void cut(std::uint32_t outline) {
    const Polygon& points = raster_.outlines[outline];
    std::int64_t from_line = firstLineFrom(points.front().y(), spacing_);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point2& to = points[i + 1 < points.size() ? i + 1 : 0];
      const std::int64_t to_line = firstLineFrom(to.y(), spacing_);
      if (from_line != to_line)
        cutEdge({from_line, 0.0, outline, static_cast<std::uint32_t>(i)}, to_line, to);
      from_line = to_line;
    }
  }

 private:
  /// @param first  line and edge at which the edge starts
  void cutEdge(Crossing first, std::int64_t to_line, const Point2& to) {
    const Point2& from = raster_.outlines[first.outline][first.edge];
    const auto count = static_cast<std::size_t>(std::abs(to_line - first.line));
    const double slope = (to.x() - from.x()) / (to.y() - from.y());
    const std::int64_t step = to_line > first.line ? 1 : -1;
    // Going up, a line at the start is crossed and one at the end is not; going down it is the other way
    // round.
    Crossing crossing = first;
    if (step < 0) --crossing.line;
    for (std::size_t i = 0; i < count; ++i, crossing.line += step) {
      const double x = from.x() + slope * (static_cast<double>(crossing.line) * spacing_ - from.y());
      crossing.x = std::clamp(x, std::min(from.x(), to.x()), std::max(from.x(), to.x()));
      raster_.crossings.push_back(crossing);
    }
  }

  Raster& raster_;
  double spacing_;
};

/// Counting sort by line, then each line by x: linear, as a line has few crossings.
void sortByLine(Raster& raster) {
  const std::vector<Crossing>& crossings = raster.crossings;
  if (crossings.empty()) return;
  const auto by_line = [](const Crossing& a, const Crossing& b) { return a.line < b.line; };
  const auto [low, high] = std::minmax_element(crossings.begin(), crossings.end(), by_line);
  const std::int64_t lowest = low->line;
  std::vector<std::uint32_t>& begin = raster.line_begin;
  begin.assign(static_cast<std::size_t>(high->line - lowest) + 2, 0);
  raster.lowest = lowest;
  for (const Crossing& crossing : crossings) ++begin[static_cast<std::size_t>(crossing.line - lowest) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t>& sorted = raster.sorted;
  sorted.resize(crossings.size());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t i = 0; i < crossings.size(); ++i)
    sorted[next[static_cast<std::size_t>(crossings[i].line - lowest)]++] = i;
  for (std::size_t line = 0; line + 1 < begin.size(); ++line)
    std::sort(sorted.begin() + begin[line], sorted.begin() + begin[line + 1],
              [&](std::uint32_t a, std::uint32_t b) {
                return crossings[a].x != crossings[b].x ? crossings[a].x < crossings[b].x : a < b;
              });
}

}  // namespace

RasterFrame::RasterFrame(double angle_rad, double bottom_mm)
    : cos_(std::cos(angle_rad)), sin_(std::sin(angle_rad)), bottom_(bottom_mm) {}

Point2 RasterFrame::intoRaster(const Point2& point) const {
  return {cos_ * point.x() + sin_ * point.y(), cos_ * point.y() - sin_ * point.x() - bottom_};
}

Point2 RasterFrame::outOfRaster(const Point2& point) const {
  const double y = point.y() + bottom_;
  return {cos_ * point.x() - sin_ * y, cos_ * y + sin_ * point.x()};
}

Box2 boxInRaster(const Box2& box, const RasterFrame& frame) {
  Polygon corners;
  for (const double x : {box.low.x(), box.high.x()})
    for (const double y : {box.low.y(), box.high.y()}) corners.push_back(frame.intoRaster({x, y}));
  return boundingBox({corners});
}

Raster rasterise(const Regions& regions, double spacing_mm, const RasterFrame& frame) {
  if (!(spacing_mm > 0.0 && std::isfinite(spacing_mm)))
    throw InvalidInput("infill spacing is " + numberText(spacing_mm) + " mm; must be positive");
  Raster raster;
  raster.spacing_mm = spacing_mm;
  for (const Region& region : regions) {
    if (!region.outer.empty()) raster.outlines.push_back(turned(region.outer, frame));
    for (const Polygon& hole : region.holes)
      if (!hole.empty()) raster.outlines.push_back(turned(hole, frame));
  }
  refuseTooManyLines(boundingBox(raster.outlines), spacing_mm);
  EdgeCutter cutter(raster, spacing_mm);
  for (std::uint32_t outline = 0; outline < raster.outlines.size(); ++outline) cutter.cut(outline);
  sortByLine(raster);
  return raster;
}

}  // namespace lamina
