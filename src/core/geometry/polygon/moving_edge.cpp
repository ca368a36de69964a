// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/moving_edge.hpp"

#include <limits>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {

EdgeCollapseEvent collapseBetween(const MovingEdge& before, const MovingEdge& edge, const MovingEdge& after) {
  const Point2 inwards = leftOf(edge.direction);
  const Point2 first = inwards - leftOf(before.direction);
  const Point2 second = leftOf(after.direction) - inwards;
  const double turning = cross(first, second);
  // Edges in one direction vanish nowhere.
  if (turning == 0.0) return {edge.start, std::numeric_limits<double>::infinity()};
  // The ends of an edge are as far from its own line as from the one that they share it with.
  const Point2 along = second.dot(after.start - edge.start) / turning * leftOf(first);
  return {edge.start + along, edge.moved_mm + inwards.dot(along)};
}

}  // namespace lamina
