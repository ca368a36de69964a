// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/vanishing_chain.hpp"

#include <limits>

namespace lamina {
namespace {

/// Of where edges vanish [mm].
constexpr double kTolerance = 1e-7;
/// Edges in one direction vanish nowhere.
constexpr double kNever = std::numeric_limits<double>::infinity();

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }
Point2 inwards(const Point2& direction) { return {-direction.y(), direction.x()}; }

}  // namespace

VanishingChain::VanishingChain(const Point2& direction) {
  edges_.push_back({Point2::Zero(), 0.0, direction});
}

void VanishingChain::add(const Point2& start, const Point2& direction) {
  edges_.push_back({start, 0.0, direction});
}

VanishingChain::Vanishing VanishingChain::vanishingOf(std::size_t edge) const {
  const Edge& before = edges_[edge - 1];
  const Edge& own = edges_[edge];
  const Edge& after = edges_[edge + 1];
  const Point2 first = inwards(own.direction) - inwards(before.direction);
  const Point2 second = inwards(after.direction) - inwards(own.direction);
  const double turning = cross(first, second);
  if (turning == 0.0) return {edge, own.start, kNever};
  // The ends of an edge are as far from its own line as from the one that they share it with.
  const Point2 along = second.dot(after.start - own.start) / turning * Point2(-first.y(), first.x());
  return {edge, own.start + along, own.moved + inwards(own.direction).dot(along)};
}

VanishingChain::Vanishing VanishingChain::nextAfter(double distance) const {
  Vanishing next;
  next.distance = kNever;
  for (std::size_t i = 1; i + 1 < edges_.size(); ++i) {
    const Vanishing vanishing = vanishingOf(i);
    if (vanishing.distance >= distance - kTolerance && vanishing.distance < next.distance) next = vanishing;
  }
  return next;
}

bool VanishingChain::isHidden(const Vanishing& vanishing) const {
  const Edge& before = edges_[vanishing.edge - 1];
  const Edge& own = edges_[vanishing.edge];
  const Edge& after = edges_[vanishing.edge + 1];
  const bool opens_before = cross(before.direction, own.direction) < 0.0;
  const bool opens_after = cross(own.direction, after.direction) < 0.0;
  if (cross(before.direction, after.direction) <= 0.0 || (opens_before && opens_after)) return false;
  if (opens_after) return before.direction.dot(vanishing.point - own.start) <= 0.0;
  if (opens_before) return after.direction.dot(vanishing.point - after.start) >= 0.0;
  return true;
}

bool VanishingChain::vanishesWithin(double distance_mm) {
  double distance = 0.0;
  while (edges_.size() > 2) {
    const Vanishing next = nextAfter(distance);
    if (!(next.distance <= distance_mm + kTolerance) || !isHidden(next)) return false;
    distance = next.distance;
    edges_.erase(edges_.begin() + static_cast<std::ptrdiff_t>(next.edge));
    edges_[next.edge].start = next.point;
    edges_[next.edge].moved = next.distance;
  }
  return true;
}

}  // namespace lamina
