// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/polygon/moving_edge.hpp"

namespace lamina {

/// Edges of an outline, one after the other, that all move to their left by the same distance, the inner ones
/// until each has shrunk to a point.
class CollapsingChain {
 public:
  /// @param direction  of the first edge; unit
  explicit CollapsingChain(const Point2& direction);
  /// The next edge, from a point on.
  void add(const Point2& start, const Point2& direction);

  /// Whether all but the first and the last edge vanish, one by one, within that distance, and where each
  /// does, what its neighbours sweep hides it. Beside a corner that opens, one neighbour turns away; the
  /// other one sweeps all that lies behind its line only up to its own end.
  bool collapsesWithin(double distance_mm);

 private:
  /// The inner edge that vanishes next, and where.
  struct Next {
    std::size_t edge = 0;
    EdgeCollapseEvent vanishing;
  };

  Next nextAfter(double distance) const;
  bool isHidden(const Next& next) const;

  std::vector<MovingEdge> edges_;
};

}  // namespace lamina
