// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "infill/lightning/edge_rows.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"

namespace lamina {

/// Branches of one layer as trees whose roots stand at the walls.
class BranchForest {
 public:
  /// Makes the branches of the layer above those of the layer below it: see `branchesUnderRoofs`.
  /// @param inside  of the layer below
  void descend(const Regions& inside, double reach_mm, double spacing_mm);

  /// Adds tips until no place of the roof is farther than half the spacing from a branch or a wall.
  void grow(const Regions& inside, const Regions& roof, double spacing_mm);

  /// Each branch from its tip to its root, or to the branch it joins; roots prolonged by the overrun.
  std::vector<Polyline> branches(double overrun_mm) const;

 private:
  static constexpr int kWall = -1;

  struct Node {
    Point2 at;
    int parent = kWall;  ///< a root has none
    bool is_gone = false;
  };

  /// A place that a tip can be joined to.
  struct Hold {
    int node = kWall;  ///< at the tip's end of the branch it lies on; none on a wall
  };

  std::vector<int> childCounts() const;
  void shorten(double reach_mm);
  /// @param counts  of children that nodes had before they were shortened
  void straighten(double reach_mm, const std::vector<int>& counts);
  void cutOff(const Regions& inside, double spacing_mm);
  void reachWalls(const EdgeRows& rows, const PointGrid& walls);
  void compact();
  void addHolds(PointGrid& grid, std::vector<Hold>& holds, int node, double step_mm) const;
  int joint(const Hold& hold, const Point2& at);

  std::vector<Node> nodes_;
};

}  // namespace lamina
