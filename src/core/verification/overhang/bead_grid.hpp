// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lamina/geometry/voxel/height_grid.hpp"
#include "verification/overhang/deposited_beads.hpp"

namespace lamina {

/// Beads sorted into cells: slices along z of the layers' frame, each with its cells in order. The time to
/// find beads near a place does not grow with the number of beads.
class BeadGrid {
 public:
  /// @param margin_mm  distance from its edge, in the plane of the layers, within which a bead must be found
  BeadGrid(const std::vector<DepositedBead>& beads, double margin_mm);

  /// Calls visit(bead index) for each bead that may have its centre line between two heights and its edge
  /// within the margin of a place, until visit returns true. A bead may be visited twice.
  /// @return whether visit returned true
  template <class Visit>
  bool visitNear(const Point2& place, double low_z, double high_z, const Visit& visit) const;

 private:
  struct Entry {
    std::uint32_t cell;
    std::uint32_t bead;
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.cell != b.cell ? a.cell < b.cell : a.bead < b.bead;
    }
  };

  void layOut(const Box3& box, const Bead& largest);
  void put(const DepositedBead& bead, std::uint32_t index, double margin_mm);
  std::size_t boundsOf(double z) const;

  HeightGrid cells_;
  double low_z_ = 0.0;
  double bounds_mm_ = 1.0;
  std::vector<std::vector<Entry>> layer_bounds_;
};

template <class Visit>
bool BeadGrid::visitNear(const Point2& place, double low_z, double high_z, const Visit& visit) const {
  const std::size_t cell = cells_.cellAt(place);
  if (cell == HeightGrid::kNoCell || high_z < low_z_) return false;
  const Entry first{static_cast<std::uint32_t>(cell), 0};
  for (std::size_t bounds = boundsOf(low_z); bounds <= boundsOf(high_z); ++bounds) {
    const std::vector<Entry>& entries = layer_bounds_[bounds];
    for (auto at = std::lower_bound(entries.begin(), entries.end(), first);
         at != entries.end() && at->cell == first.cell; ++at)
      if (visit(static_cast<std::size_t>(at->bead))) return true;
  }
  return false;
}

}  // namespace lamina
