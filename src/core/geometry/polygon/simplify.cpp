// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/polygon/simplify.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/polygon/chain_splitting.hpp"
#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// Compares distances from a segment without dividing by its length.
class SegmentDistance {
 public:
  SegmentDistance(const Point2& a, const Point2& b)
      : a_(a), b_(b), along_(b - a), squared_length_(along_.squaredNorm()) {}

  /// What stands for a distance here: its square times that of the length; of a point just the square.
  double scaled(double squared_distance) const {
    return squared_length_ == 0.0 ? squared_distance : squared_distance * squared_length_;
  }

  double scaledTo(const Point2& point) const {
    const Point2 offset = point - a_;
    const double projection = offset.dot(along_);
    if (projection <= 0.0) return scaled(offset.squaredNorm());
    if (projection >= squared_length_) return scaled((point - b_).squaredNorm());
    const double area = cross(along_, offset);
    return area * area;
  }

 private:
  Point2 a_;
  Point2 b_;
  Point2 along_;
  double squared_length_;
};

std::size_t farthestFrom(const Polygon& polygon, const Point2& point) {
  std::size_t farthest = 0;
  double farthest_distance = -1.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double distance = (polygon[i] - point).squaredNorm();
    if (distance > farthest_distance) farthest = i, farthest_distance = distance;
  }
  return farthest;
}

/// The points of an outline that stay. Chains of it may run past its end: indices wrap round.
class Simplification {
 public:
  Simplification(const Polygon& points, double tolerance)
      : points_(points), squared_tolerance_(tolerance * tolerance), is_kept_(points.size(), false) {}

  void keepChain(std::size_t first, std::size_t last) {
    const auto split = [this](std::size_t from, std::size_t to) { return splitBetween(from, to); };
    for (const std::size_t i : keptOfChain(first, last, split)) is_kept_[i % points_.size()] = true;
  }

  Polygon kept() const {
    Polygon result;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (is_kept_[i]) result.push_back(points_[i]);
    return result;
  }

 private:
  const Point2& at(std::size_t i) const { return points_[i < points_.size() ? i : i - points_.size()]; }

  std::size_t splitBetween(std::size_t from, std::size_t to) const {
    const SegmentDistance segment(at(from), at(to));
    double worst = segment.scaled(squared_tolerance_);
    std::size_t at_worst = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double distance = segment.scaledTo(at(i));
      if (distance > worst) worst = distance, at_worst = i;
    }
    return at_worst;
  }

  const Polygon& points_;
  double squared_tolerance_;
  std::vector<bool> is_kept_;
};

}  // namespace

Polygon simplify(const Polygon& polygon, double tolerance_mm) {
  if (polygon.size() < 3) return {};
  // Two points that stay whatever the tolerance: far apart, so that the chains between them have a direction.
  const std::size_t first = farthestFrom(polygon, polygon.front());
  const std::size_t second = farthestFrom(polygon, polygon[first]);
  const auto [low, high] = std::minmax(first, second);
  if (low == high) return {};
  Simplification simplification(polygon, tolerance_mm);
  simplification.keepChain(low, high);
  simplification.keepChain(high, low + polygon.size());
  Polygon result = simplification.kept();
  if (result.size() < 3) result.clear();
  return result;
}

std::vector<Polygon> simplify(const std::vector<Polygon>& polygons, double tolerance_mm) {
  std::vector<Polygon> result;
  result.reserve(polygons.size());
  for (const Polygon& polygon : polygons) {
    Polygon simplified = simplify(polygon, tolerance_mm);
    if (!simplified.empty()) result.push_back(std::move(simplified));
  }
  return result;
}

}  // namespace lamina
