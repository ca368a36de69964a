// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/collapsing_chain.hpp"

#include <limits>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// Of where edges vanish [mm].
constexpr double kChainTolerance = 1e-7;

}  // namespace

CollapsingChain::CollapsingChain(const Point2& direction) {
  edges_.push_back({Point2::Zero(), 0.0, direction});
}

void CollapsingChain::add(const Point2& start, const Point2& direction) {
  edges_.push_back({start, 0.0, direction});
}

CollapsingChain::Next CollapsingChain::nextAfter(double distance) const {
  Next next{0, {Point2::Zero(), std::numeric_limits<double>::infinity()}};
  for (std::size_t i = 1; i + 1 < edges_.size(); ++i) {
    const EdgeCollapseEvent vanishing = collapseBetween(edges_[i - 1], edges_[i], edges_[i + 1]);
    if (vanishing.moved_mm >= distance - kChainTolerance && vanishing.moved_mm < next.vanishing.moved_mm)
      next = {i, vanishing};
  }
  return next;
}

bool CollapsingChain::isHidden(const Next& next) const {
  const MovingEdge& before = edges_[next.edge - 1];
  const MovingEdge& own = edges_[next.edge];
  const MovingEdge& after = edges_[next.edge + 1];
  const Point2& point = next.vanishing.point;
  const bool opens_before = cross(before.direction, own.direction) < 0.0;
  const bool opens_after = cross(own.direction, after.direction) < 0.0;
  if (cross(before.direction, after.direction) <= 0.0 || (opens_before && opens_after)) return false;
  if (opens_after) return before.direction.dot(point - own.start) <= 0.0;
  if (opens_before) return after.direction.dot(point - after.start) >= 0.0;
  return true;
}

bool CollapsingChain::collapsesWithin(double distance_mm) {
  double distance = 0.0;
  while (edges_.size() > 2) {
    const Next next = nextAfter(distance);
    if (!(next.vanishing.moved_mm <= distance_mm + kChainTolerance) || !isHidden(next)) return false;
    distance = next.vanishing.moved_mm;
    edges_.erase(edges_.begin() + static_cast<std::ptrdiff_t>(next.edge));
    edges_[next.edge].start = next.vanishing.point;
    edges_[next.edge].moved_mm = distance;
  }
  return true;
}

}  // namespace lamina
