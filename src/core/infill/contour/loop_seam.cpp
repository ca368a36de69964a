// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/loop_seam.hpp"

#include <algorithm>
#include <cmath>

#include "infill/fill_seed.hpp"

namespace lamina {
namespace {

/// Points nearer to each other than this are one [mm].
constexpr double kSamePlace = 1e-6;

bool isFartherLeft(const Point2& a, const Point2& b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

/// From the first point along the loop to that one [mm].
double positionOf(const Polygon& loop, std::size_t point) {
  return length({loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(point) + 1});
}

/// The loop once round, from a place back to that place.
Polyline roundFrom(const Polygon& loop, double start) {
  Polyline points;
  std::size_t edge = 0;
  double edge_length = (loop[1] - loop[0]).norm();
  while (start >= edge_length && edge + 1 < loop.size()) {
    start -= edge_length;
    ++edge;
    edge_length = (loop[edge + 1 < loop.size() ? edge + 1 : 0] - loop[edge]).norm();
  }
  const Point2& next = loop[edge + 1 < loop.size() ? edge + 1 : 0];
  const double part = edge_length > 0.0 ? std::min(1.0, start / edge_length) : 0.0;
  points.emplace_back(loop[edge] + part * (next - loop[edge]));
  for (std::size_t k = 1; k <= loop.size(); ++k) {
    const Point2& point = loop[(edge + k) % loop.size()];
    if ((point - points.back()).norm() > kSamePlace) points.push_back(point);
  }
  if ((points.front() - points.back()).norm() > kSamePlace) points.push_back(points.front());
  return points;
}

Polyline shortened(Polyline line, double by) {
  while (line.size() > 2) {
    const double last = (line.back() - line[line.size() - 2]).norm();
    if (last > by + kSamePlace) break;
    by -= last;
    line.pop_back();
  }
  const Point2 back = line[line.size() - 2] - line.back();
  line.back() += std::max(0.0, by) * back.normalized();
  return line;
}

}  // namespace

LoopSeam::LoopSeam(const InfillRequest& request)
    : placement_(request.settings.perimeters.seam),
      step_(request.settings.perimeters.seam_step * request.pitch_mm),
      layer_(static_cast<double>(request.layer)),
      random_(randomOf(request.settings.perimeters.seed, request, 0)) {}

double LoopSeam::startOn(const Polygon& loop, std::size_t level) {
  const double whole = perimeter(loop);
  if (placement_ == PerimeterSeam::Random) return random_.uniform(0.0, whole);
  const auto leftmost = std::min_element(loop.begin(), loop.end(), isFartherLeft);
  const double from = positionOf(loop, static_cast<std::size_t>(leftmost - loop.begin()));
  return std::fmod(from + (layer_ + static_cast<double>(level)) * step_, whole);
}

FillPath openedLoop(const Polygon& loop, double start_mm, double gap_mm) {
  FillPath path;
  path.points = roundFrom(loop, start_mm);
  path.is_closed = !(gap_mm > 0.0 && length(path.points) >= 2.0 * gap_mm);
  if (path.is_closed)
    path.points.pop_back();
  else
    path.points = shortened(std::move(path.points), gap_mm);
  return path;
}

}  // namespace lamina
