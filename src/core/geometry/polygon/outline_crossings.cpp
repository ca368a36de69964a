// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/outline_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "geometry/polygon/one_side.hpp"
#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// Pairs of edges looked at, per edge, before giving up.
constexpr std::size_t kMostPairs = 64;
/// Edges for each column of the sweep squared: a plate with n times the holes has about sqrt(n) times the
/// columns, so that as many edges as before are looked at for each.
constexpr double kEdgesPerColumn = 512.0;

struct Edge {
  Point2 from;
  Point2 to;
  std::uint32_t outline;
  std::uint32_t index;
};

/// An edge that the sweep has come to and not yet left.
struct ActiveEdge {
  double low_x, high_x, high_y;
  std::uint32_t edge;
};

bool areApart(const Edge& a, const Edge& b) {
  return leavesOnOneSide(a.from, a.to, b.from, b.to) || leavesOnOneSide(b.from, b.to, a.from, a.to);
}

/// Neighbours share a point; they are apart otherwise unless the one folds back onto the other.
bool areNeighboursApart(const Edge& first, const Edge& second) {
  if (std::abs(side(first.from, first.to, second.to)) > kFlatTriangle) return true;
  return (first.to - first.from).dot(second.to - second.from) > 0.0;
}

class Sweep {
 public:
  explicit Sweep(const std::vector<Polygon>& outlines) : outlines_(outlines) {
    std::size_t count = 0;
    for (const Polygon& outline : outlines) count += outline.size();
    edges_.reserve(count);
    from_below_.reserve(count);
    for (std::uint32_t i = 0; i < outlines.size(); ++i) addEdges(i);
    std::sort(from_below_.begin(), from_below_.end());
    divide();
  }

  bool run() {
    std::size_t pairs_left = kMostPairs * edges_.size();
    for (const auto& [low_y, edge] : from_below_) {
      const ActiveEdge entering = activeEdge(edge);
      const std::size_t last = columnOf(entering.high_x);
      for (std::size_t column = columnOf(entering.low_x); column <= last; ++column) {
        std::vector<ActiveEdge>& active = columns_[column];
        if (pairs_left < active.size() || !standsApart(entering, low_y, active)) return false;
        pairs_left -= active.size();
        active.push_back(entering);
      }
    }
    return true;
  }

 private:
  /// Into columns of equal width, which each hold the edges that reach them.
  void divide() {
    double high_x = -low_x_;
    for (const Edge& edge : edges_) {
      low_x_ = std::min({low_x_, edge.from.x(), edge.to.x()});
      high_x = std::max({high_x, edge.from.x(), edge.to.x()});
    }
    const double count = std::max(1.0, std::sqrt(static_cast<double>(edges_.size()) / kEdgesPerColumn));
    columns_.resize(static_cast<std::size_t>(count));
    if (high_x > low_x_) columns_per_mm_ = static_cast<double>(columns_.size()) / (high_x - low_x_);
  }

  std::size_t columnOf(double x) const {
    return std::min(columns_.size() - 1, static_cast<std::size_t>((x - low_x_) * columns_per_mm_));
  }

  void addEdges(std::uint32_t outline) {
    const Polygon& points = outlines_[outline];
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const Point2& a = points[i];
      const Point2& b = points[i + 1 < points.size() ? i + 1 : 0];
      from_below_.emplace_back(std::min(a.y(), b.y()), static_cast<std::uint32_t>(edges_.size()));
      edges_.push_back({a, b, outline, i});
    }
  }

  ActiveEdge activeEdge(std::uint32_t edge) const {
    const auto [low_x, high_x] = std::minmax(edges_[edge].from.x(), edges_[edge].to.x());
    return {low_x, high_x, std::max(edges_[edge].from.y(), edges_[edge].to.y()), edge};
  }

  /// From all edges of a column that reach up to its lower end; those that do not are let go.
  bool standsApart(const ActiveEdge& entering, double low_y, std::vector<ActiveEdge>& active) const {
    std::size_t kept = 0;
    for (const ActiveEdge& other : active) {
      if (other.high_y < low_y) continue;
      active[kept++] = other;
      const bool is_beside = other.high_x < entering.low_x || entering.high_x < other.low_x;
      if (!is_beside && !pairIsApart(edges_[other.edge], edges_[entering.edge])) return false;
    }
    active.resize(kept);
    return true;
  }

  bool pairIsApart(const Edge& a, const Edge& b) const {
    if (a.outline == b.outline) {
      const auto last = static_cast<std::uint32_t>(outlines_[a.outline].size() - 1);
      if ((a.index < last ? a.index + 1 : 0) == b.index) return areNeighboursApart(a, b);
      if ((b.index < last ? b.index + 1 : 0) == a.index) return areNeighboursApart(b, a);
    }
    return areApart(a, b);
  }

  const std::vector<Polygon>& outlines_;
  std::vector<Edge> edges_;
  std::vector<std::pair<double, std::uint32_t>> from_below_;  ///< lower ends, and edges
  double low_x_ = std::numeric_limits<double>::infinity();
  double columns_per_mm_ = 0.0;
  std::vector<std::vector<ActiveEdge>> columns_;
};

}  // namespace

bool areSurelyApart(const std::vector<Polygon>& outlines) { return Sweep(outlines).run(); }

}  // namespace lamina
