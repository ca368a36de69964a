// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/slicing/volumetric/head_room.hpp"
#include "slicing/volumetric/growth_lattice.hpp"

namespace lamina {

/// Parameters of the search for leans.
struct LeanQuestion {
  double greatest_rad = 0.6;
  /// Growth deposited ahead of a place, besides what has grown before it: its own layer.
  double ahead_mm = 0.2;
};

/// Angles by which the head leans from the normal of a part's layers towards upright to avoid bed and part.
class HeadLean {
 public:
  /// Searches leans in steps of 5 deg at one place in every cube of about 2 mm. Between places the lean is
  /// smoothed, but never below what the nearest places need.
  /// @throws Cancelled
  HeadLean(const CellGraph& cells, const GrowthLattice& lattice, const HeadRoom& room,
           const LeanQuestion& question, Progress& progress);

  /// Direction against the tool axis at a place of a layer with this normal.
  Point3 direction(const Point3& place, const Point3& normal) const;
  /// Greatest lean [rad].
  double greatest() const { return greatest_; }
  /// Share of the volume in which no lean avoids a collision.
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

/// A direction turned towards +z by an angle, at most up to +z.
Point3 turnedUp(const Point3& direction, double angle_rad);

}  // namespace lamina
