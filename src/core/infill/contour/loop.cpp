// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// A link may touch loops at its ends: what lies within this part of its length there is left aside.
constexpr double kTouching = 1e-3;

struct EdgePlace {
  double squared = std::numeric_limits<double>::infinity();
  double part = 0.0;  ///< of the edge
};

EdgePlace nearestOnEdge(const Point2& from, const Point2& to, const Point2& point) {
  const Point2 along = to - from;
  const double part = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return {(from + part * along - point).squaredNorm(), part};
}

}  // namespace

Loop::Loop(Polygon points, std::vector<double> width_mm)
    : points_(std::move(points)), width_(std::move(width_mm)) {
  at_.reserve(points_.size() + 1);
  at_.push_back(0.0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    at_.push_back(at_.back() + (endOf(i) - points_[i]).norm());
    box_.include(points_[i]);
  }
}

double Loop::wrapped(double position) const {
  const double rest = std::fmod(position, length());
  const double positive = rest < 0.0 ? rest + length() : rest;
  return positive < length() ? positive : 0.0;
}

std::size_t Loop::edgeAt(double position) const {
  const auto after = std::upper_bound(at_.begin() + 1, at_.end() - 1, position);
  return static_cast<std::size_t>(after - at_.begin()) - 1;
}

Point2 Loop::pointAt(double position) const {
  const double inside = wrapped(position);
  const std::size_t edge = edgeAt(inside);
  const double part = (inside - at_[edge]) / (at_[edge + 1] - at_[edge]);
  return points_[edge] + part * (endOf(edge) - points_[edge]);
}

double Loop::widthAt(double position) const { return edgeWidth(edgeAt(wrapped(position))); }

LoopPlace Loop::nearest(const Point2& point) const {
  EdgePlace best;
  std::size_t best_edge = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const EdgePlace place = nearestOnEdge(points_[i], endOf(i), point);
    if (place.squared >= best.squared) continue;
    best = place;
    best_edge = i;
  }
  return {at_[best_edge] + best.part * (at_[best_edge + 1] - at_[best_edge]), std::sqrt(best.squared)};
}

template <class Visit>
void Loop::visitEdges(const LoopStretch& stretch, const Visit& visit) const {
  const double start = wrapped(stretch.middle_mm - std::min(stretch.reach_mm, 0.5 * length()));
  std::size_t edge = edgeAt(start);
  double left = start - at_[edge] + 2.0 * stretch.reach_mm;
  for (std::size_t count = 0; count < points_.size() && left > 0.0; ++count) {
    visit(edge);
    left -= at_[edge + 1] - at_[edge];
    edge = edge + 1 < points_.size() ? edge + 1 : 0;
  }
}

LoopPlace Loop::nearest(const Point2& point, const LoopStretch& stretch) const {
  LoopPlace best{stretch.middle_mm, std::numeric_limits<double>::infinity()};
  visitEdges(stretch, [&](std::size_t edge) {
    const EdgePlace place = nearestOnEdge(points_[edge], endOf(edge), point);
    const double distance = std::sqrt(place.squared);
    if (distance < best.distance_mm) best = {at_[edge] + place.part * (at_[edge + 1] - at_[edge]), distance};
  });
  return best;
}

std::optional<LoopPlace> Loop::hit(const Point2& from, const Point2& direction,
                                   const LoopStretch& stretch) const {
  std::optional<LoopPlace> best;
  visitEdges(stretch, [&](std::size_t edge) {
    const Point2 along = endOf(edge) - points_[edge];
    const double turn = cross(direction, along);
    if (turn == 0.0) return;
    const double distance = cross(points_[edge] - from, along) / turn;
    const double part = cross(points_[edge] - from, direction) / turn;
    if (part < 0.0 || part > 1.0 || distance < 0.0 || (best && distance >= best->distance_mm)) return;
    best = LoopPlace{at_[edge] + part * (at_[edge + 1] - at_[edge]), distance};
  });
  return best;
}

bool Loop::isCrossedBy(const Point2& from, const Point2& to) const {
  const Point2 a = from + kTouching * (to - from);
  const Point2 b = to - kTouching * (to - from);
  const Point2 low = a.cwiseMin(b);
  const Point2 high = a.cwiseMax(b);
  if ((high.array() < box_.low.array()).any() || (low.array() > box_.high.array()).any()) return false;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (areCrossing(a, b, points_[i], endOf(i))) return true;
  return false;
}

}  // namespace lamina
