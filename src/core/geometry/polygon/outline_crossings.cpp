// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/outline_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// Twice the area of a triangle that counts as flat [mm²]: above the rounding of coordinates of metres.
constexpr double kFlat = 1e-8;
/// Pairs of edges looked at, per edge, before giving up.
constexpr std::size_t kMostPairs = 64;

struct Edge {
  Point2 from;
  Point2 to;
  double low_x, high_x, low_y, high_y;
  std::uint32_t outline;
  std::uint32_t index;
};

/// Whether the line through a and b has c and d clearly on one side.
bool leavesOnOneSide(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double first = side(a, b, c);
  const double second = side(a, b, d);
  return (first > kFlat && second > kFlat) || (first < -kFlat && second < -kFlat);
}

bool areApart(const Edge& a, const Edge& b) {
  return a.high_x < b.low_x || b.high_x < a.low_x || leavesOnOneSide(a.from, a.to, b.from, b.to) ||
         leavesOnOneSide(b.from, b.to, a.from, a.to);
}

/// Neighbours share a point; they are apart otherwise unless the one folds back onto the other.
bool areNeighboursApart(const Edge& first, const Edge& second) {
  if (std::abs(side(first.from, first.to, second.to)) > kFlat) return true;
  return (first.to - first.from).dot(second.to - second.from) > 0.0;
}

class Sweep {
 public:
  explicit Sweep(const std::vector<Polygon>& outlines) : outlines_(outlines) {
    std::size_t count = 0;
    for (const Polygon& outline : outlines) count += outline.size();
    edges_.reserve(count);
    for (std::uint32_t i = 0; i < outlines.size(); ++i) addEdges(i);
    std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.low_y < b.low_y; });
  }

  bool run() {
    std::size_t pairs_left = kMostPairs * edges_.size();
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      if (pairs_left < active_.size() || !standsApart(edges_[i])) return false;
      pairs_left -= active_.size();
      active_.push_back(i);
    }
    return true;
  }

 private:
  void addEdges(std::uint32_t outline) {
    const Polygon& points = outlines_[outline];
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const Point2& a = points[i];
      const Point2& b = points[i + 1 < points.size() ? i + 1 : 0];
      const auto [low_x, high_x] = std::minmax(a.x(), b.x());
      const auto [low_y, high_y] = std::minmax(a.y(), b.y());
      edges_.push_back({a, b, low_x, high_x, low_y, high_y, outline, i});
    }
  }

  /// From all edges that reach up to its lower end; those that do not are let go.
  bool standsApart(const Edge& edge) {
    std::size_t kept = 0;
    bool is_apart = true;
    for (const std::uint32_t other : active_) {
      if (edges_[other].high_y < edge.low_y) continue;
      active_[kept++] = other;
      is_apart = is_apart && pairIsApart(edges_[other], edge);
    }
    active_.resize(kept);
    return is_apart;
  }

  bool pairIsApart(const Edge& a, const Edge& b) const {
    if (a.outline == b.outline) {
      const auto size = static_cast<std::uint32_t>(outlines_[a.outline].size());
      if ((a.index + 1) % size == b.index) return areNeighboursApart(a, b);
      if ((b.index + 1) % size == a.index) return areNeighboursApart(b, a);
    }
    return areApart(a, b);
  }

  const std::vector<Polygon>& outlines_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> active_;
};

}  // namespace

bool areSurelyApart(const std::vector<Polygon>& outlines) { return Sweep(outlines).run(); }

}  // namespace lamina
