// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/polygon/moving_edge.hpp"

namespace lamina {

/// Successive edges of an outline that all move to their left by the same distance, each inner one until it
/// has shrunk to a point.
class CollapsingChain {
 public:
  /// @param direction  of the first edge, of unit length
  explicit CollapsingChain(const Point2& direction);
  /// Adds the next edge, which begins at `start`.
  void add(const Point2& start, const Point2& direction);

  /// Whether, within that distance, all edges but the first and the last vanish one after the other, each
  /// hidden by the area that its neighbours sweep. At a corner that opens, one neighbour turns away; the
  /// other neighbour then sweeps the area behind its line only up to its own end.
  bool collapsesWithin(double distance_mm);

 private:
  /// The inner edge that vanishes next, and where it does.
  struct Next {
    std::size_t edge = 0;
    EdgeCollapseEvent vanishing;
  };

  Next nextAfter(double distance) const;
  bool isHidden(const Next& next) const;

  std::vector<MovingEdge> edges_;
};

}  // namespace lamina
