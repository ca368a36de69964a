// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/slicing/volumetric/head_room.hpp"
#include "slicing/volumetric/growth_lattice.hpp"

namespace lamina {

/// What leans are looked for.
struct LeanQuestion {
  double greatest_rad = 0.6;
  double ahead_mm = 0.2;  ///< growth deposited before a place besides what has grown before it: its layer
};

/// How far the head leans from a part's layers towards upright, so that it clears bed and part.
class HeadLean {
 public:
  /// Looks at one place in every cube of about 2 mm, for leans in steps of 5 deg. Between places the lean is
  /// evened out, never below what the nearest ones need.
  /// @throws Cancelled
  HeadLean(const CellGraph& cells, const GrowthLattice& lattice, const HeadRoom& room,
           const LeanQuestion& question, Progress& progress);

  /// The direction against the tool axis at a place of a layer.
  Point3 direction(const Point3& place, const Point3& normal) const;
  /// Greatest lean [rad].
  double greatest() const { return greatest_; }
  /// Of the volume: where the head is not clear by any lean.
  double shut() const { return shut_; }

 private:
  void look(const GrowthLattice& lattice, const HeadRoom& room, const LeanQuestion& question,
            Progress& progress);
  void evenOut();
  std::size_t numberOf(int i, int j, int k) const;

  const CellGraph& cells_;
  VoxelFrame frame_;
  std::vector<float> lean_;  // negative where there is no part
  double greatest_ = 0.0;
  double shut_ = 0.0;
};

/// A direction turned towards up by an angle, at most to up.
Point3 turnedUp(const Point3& direction, double angle_rad);

}  // namespace lamina
