// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/edge_collapse_inset.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "geometry/polygon/collapsing_chain.hpp"
#include "geometry/polygon/nesting.hpp"
#include "geometry/polygon/outline_crossings.hpp"
#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// 1 + cos of a turn: below this a mitre is longer than twice the offset.
constexpr double kLongestMitre = 0.5;
/// 1 + cos of a turn this near to a half turn has no usable mitre.
constexpr double kHalfTurn = 0.01;
/// Sine of the turn between two edges that meet after those between them have vanished.
constexpr double kLeastTurn = 0.01;
constexpr double kTolerance = 1e-9;  // mm

/// One outline whose edges move to their left by the same distance, as a ring from which edges are taken out.
class MovingOutline {
 public:
  MovingOutline(const Polygon& points, double distance)
      : points_(points),
        distance_(distance),
        count_(static_cast<std::uint32_t>(points.size())),
        left_(count_),
        edges_(count_) {}

  std::optional<Polygon> moved() {
    if (count_ < 3 || !findDirections() || !findStarts() || !takeOutInverted() || !cellsAreSound())
      return std::nullopt;
    Polygon result;
    result.reserve(left_);
    for (std::uint32_t i = 0; i < count_; ++i)
      if (!edges_[i].is_out) result.push_back(edges_[i].start);
    return result;
  }

 private:
  struct Edge {
    Point2 direction;
    Point2 start;  ///< after the move
    std::uint32_t previous;
    std::uint32_t next;
    bool is_out = false;
  };

  std::uint32_t after(std::uint32_t i) const { return i + 1 < count_ ? i + 1 : 0; }
  std::uint32_t before(std::uint32_t i) const { return i > 0 ? i - 1 : count_ - 1; }

  bool findDirections() {
    for (std::uint32_t i = 0; i < count_; ++i) {
      const Point2 along = points_[after(i)] - points_[i];
      const double length = along.norm();
      if (!(length > kTolerance)) return false;
      edges_[i].direction = along / length;
      edges_[i].previous = before(i);
      edges_[i].next = after(i);
    }
    return true;
  }

  bool findStarts() {
    for (std::uint32_t i = 0; i < count_; ++i) {
      const Point2& from = edges_[before(i)].direction;
      const Point2& to = edges_[i].direction;
      const double mitre = 1.0 + from.dot(to);
      if (mitre < (cross(from, to) < 0.0 ? kLongestMitre : kHalfTurn)) return false;
      edges_[i].start = points_[i] + distance_ / mitre * (leftOf(from) + leftOf(to));
    }
    return true;
  }

  bool isInverted(std::uint32_t i) const {
    return (edges_[edges_[i].next].start - edges_[i].start).dot(edges_[i].direction) <= kTolerance;
  }

  bool takeOutInverted() {
    std::vector<std::uint32_t> suspects;
    for (std::uint32_t i = 0; i < count_; ++i)
      if (isInverted(i)) suspects.push_back(i);
    while (!suspects.empty()) {
      const std::uint32_t i = suspects.back();
      suspects.pop_back();
      if (edges_[i].is_out || !isInverted(i)) continue;
      if (!takeOut(i)) return false;
      suspects.push_back(edges_[i].previous);
      suspects.push_back(edges_[i].next);
    }
    return true;
  }

  /// Joins the neighbours of an edge where their moved lines meet.
  bool takeOut(std::uint32_t i) {
    Edge& a = edges_[edges_[i].previous];
    Edge& b = edges_[edges_[i].next];
    const double turn = cross(a.direction, b.direction);
    if (--left_ < 3 || turn < kLeastTurn) return false;
    const Point2 on_a = points_[edges_[i].previous] + distance_ * leftOf(a.direction);
    const Point2 on_b = points_[edges_[i].next] + distance_ * leftOf(b.direction);
    b.start = on_a + cross(on_b - on_a, b.direction) / turn * a.direction;
    edges_[i].is_out = true;
    a.next = edges_[i].next;
    b.previous = edges_[i].previous;
    return true;
  }

  bool cellsAreSound() const {
    if (left_ == count_) return true;
    for (std::uint32_t i = 0; i < count_; ++i)
      if (!edges_[i].is_out && edges_[i].next != after(i) && !cellsAreSound(i, edges_[i].next)) return false;
    return true;
  }

  bool cellsAreSound(std::uint32_t first, std::uint32_t last) const {
    CollapsingChain chain(edges_[first].direction);
    for (std::uint32_t i = after(first);; i = after(i)) {
      if (isNearMoved({edges_[first].previous, first, last, edges_[last].next}, points_[i])) return false;
      chain.add(points_[i], edges_[i].direction);
      if (i == last) return chain.collapsesWithin(distance_);
    }
  }

  /// An edge may vanish behind one that by then is shorter than what it must hide.
  bool isNearMoved(const std::array<std::uint32_t, 4>& edges, const Point2& corner) const {
    return std::any_of(edges.begin(), edges.end(), [&](std::uint32_t i) {
      const Point2 nearest = nearestOnSegment(edges_[i].start, edges_[edges_[i].next].start, corner);
      return (nearest - corner).norm() < distance_ - kTolerance;
    });
  }

  const Polygon& points_;
  double distance_;
  std::uint32_t count_;
  std::uint32_t left_;
  std::vector<Edge> edges_;
};

}  // namespace

std::optional<Region> insetByEdgeCollapse(const Region& region, double distance_mm) {
  std::vector<Polygon> outlines;
  outlines.reserve(1 + region.holes.size());
  std::optional<Polygon> outer = MovingOutline(region.outer, distance_mm).moved();
  if (!outer) return std::nullopt;
  outlines.push_back(std::move(*outer));
  for (const Polygon& hole : region.holes) {
    std::optional<Polygon> moved = MovingOutline(hole, distance_mm).moved();
    if (!moved) return std::nullopt;
    outlines.push_back(std::move(*moved));
  }
  if (!areSurelyApart(outlines)) return std::nullopt;
  std::optional<Regions> nested = nest(outlines);
  if (!nested || nested->size() != 1) return std::nullopt;
  return std::move(nested->front());
}

}  // namespace lamina
