// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/raster_walk.hpp"

#include <algorithm>

namespace lamina {

RasterWalk::RasterWalk(const Raster& raster)
    : raster_(raster), position_(raster.sorted.size()), outline_begin_(raster.outlines.size() + 1, 0) {
  for (std::uint32_t i = 0; i < raster.sorted.size(); ++i) position_[raster.sorted[i]] = i;
  for (const Crossing& crossing : raster.crossings) ++outline_begin_[crossing.outline + 1];
  for (std::size_t i = 1; i < outline_begin_.size(); ++i) outline_begin_[i] += outline_begin_[i - 1];
}

Point2 RasterWalk::pointAt(std::uint32_t crossing) const {
  const Crossing& at = raster_.crossings[crossing];
  return {at.x, static_cast<double>(at.line) * raster_.spacing_mm};
}

bool RasterWalk::climbs(std::uint32_t crossing) const {
  const Crossing& at = raster_.crossings[crossing];
  const Polygon& outline = raster_.outlines[at.outline];
  const std::size_t end = at.edge + 1 < outline.size() ? at.edge + 1 : 0;
  return outline[end].y() > outline[at.edge].y();
}

std::uint32_t RasterWalk::following(std::uint32_t crossing) const {
  const std::uint32_t outline = raster_.crossings[crossing].outline;
  return crossing + 1 < outline_begin_[outline + 1] ? crossing + 1 : outline_begin_[outline];
}

std::uint32_t RasterWalk::preceding(std::uint32_t crossing) const {
  const std::uint32_t outline = raster_.crossings[crossing].outline;
  return crossing > outline_begin_[outline] ? crossing - 1 : outline_begin_[outline + 1] - 1;
}

std::uint32_t RasterWalk::next(std::uint32_t crossing, Vertical direction) const {
  return climbs(crossing) == (direction == Vertical::Up) ? following(crossing) : preceding(crossing);
}

Polyline RasterWalk::chain(std::uint32_t crossing, Vertical direction) const {
  const bool goes_forward = climbs(crossing) == (direction == Vertical::Up);
  const std::uint32_t end = goes_forward ? following(crossing) : preceding(crossing);
  Polyline points;
  if (goes_forward) {
    points.push_back(pointAt(crossing));
    appendBetween(crossing, end, points);
    points.push_back(pointAt(end));
  } else {
    points.push_back(pointAt(end));
    appendBetween(end, crossing, points);
    points.push_back(pointAt(crossing));
    std::reverse(points.begin(), points.end());
  }
  return points;
}

void RasterWalk::appendBetween(std::uint32_t from, std::uint32_t to, Polyline& points) const {
  const Crossing& start = raster_.crossings[from];
  const Crossing& end = raster_.crossings[to];
  const Polygon& outline = raster_.outlines[start.outline];
  const std::size_t size = outline.size();
  std::size_t count = end.edge >= start.edge ? end.edge - start.edge : end.edge + size - start.edge;
  // Both on one edge, the end before the start: once round.
  if (count == 0 && to <= from) count = size;
  for (std::size_t step = 1; step <= count; ++step) points.push_back(outline[(start.edge + step) % size]);
}

std::optional<std::size_t> RasterWalk::insideLineAt(std::int64_t line, double x) const {
  const std::int64_t index = line - raster_.lowest;
  if (index < 0 || index + 1 >= static_cast<std::int64_t>(raster_.line_begin.size())) return std::nullopt;
  const auto begin = raster_.sorted.begin() + raster_.line_begin[static_cast<std::size_t>(index)];
  const auto end = raster_.sorted.begin() + raster_.line_begin[static_cast<std::size_t>(index) + 1];
  const auto beyond = std::upper_bound(
      begin, end, x, [this](double value, std::uint32_t c) { return value < raster_.crossings[c].x; });
  const auto position = static_cast<std::size_t>(beyond - raster_.sorted.begin());
  if (position % 2 == 0) return std::nullopt;
  return position / 2;
}

bool RasterWalk::isInside(std::int64_t line, double from_x, double to_x) const {
  constexpr double kOnOutline = 1e-6;
  const std::optional<std::size_t> inside = insideLineAt(line, 0.5 * (from_x + to_x));
  return inside && raster_.crossings[leftEnd(*inside)].x <= std::min(from_x, to_x) + kOnOutline &&
         raster_.crossings[rightEnd(*inside)].x >= std::max(from_x, to_x) - kOnOutline;
}

}  // namespace lamina
