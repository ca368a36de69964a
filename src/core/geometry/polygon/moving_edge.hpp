// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// An edge of an outline that moves to its left while its ends follow its neighbours.
struct MovingEdge {
  Point2 start;
  double moved_mm;   ///< distance by which the edge had already moved when it started there
  Point2 direction;  ///< of unit length
};

/// Point and time at which an edge has shrunk to a point.
struct EdgeCollapseEvent {
  Point2 point;
  double moved_mm;  ///< distance by which the edge has moved then; infinite if it never shrinks to a point
};

/// Where an edge vanishes between the edges before and after it. This edge and the one after it start at the
/// points where each meets the edge before it.
EdgeCollapseEvent collapseBetween(const MovingEdge& before, const MovingEdge& edge, const MovingEdge& after);

}  // namespace lamina
