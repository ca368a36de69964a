// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/spatial/signed_distance.hpp"
#include "lamina/slicing/curved/vertex_motion.hpp"

namespace lamina {

/// The side of a part that shells stay on.
enum class PartSide { Inside, Outside };

/// What ends a shell.
struct ShellLimits {
  const SignedDistance* part = nullptr;  ///< shells stay on one side of its surface; no end if null
  PartSide part_side = PartSide::Inside;
  const NearestTriangle* rest = nullptr;  ///< the part's surface but for that propagated; none if null
  std::optional<ShellBound> bound;        ///< shells stay on its side
  double farthest_mm = 0.0;               ///< no offset beyond it is asked for
  double step_mm = 0.2;                   ///< between the offsets at which leaving the part is looked for

  /// How far a point lies on the side of the part that shells stay on [mm].
  double allowed(const Point3& point) const {
    const double inside = part->at(point).inside_mm;
    return part_side == PartSide::Inside ? inside : -inside;
  }
};

/// How far each vertex of a surface may be propagated.
struct VertexReach {
  /// Offset from which on the vertex is nearer to another place of the surface than to its own: the radius of
  /// the greatest ball that touches the surface there from the front [mm]. `farthest_mm` if it is not
  /// reached.
  std::vector<double> collapse_mm;
  /// Offset at which its path leaves the part for the first time [mm]; infinite if it does not.
  std::vector<double> exit_mm;
  /// Offset at which its path crosses the bound [mm]; infinite if it does not.
  std::vector<double> bound_mm;
};

/// A surface about to move. Its vertices may be more than those of the source it is a subdivision of.
struct MovableSurface {
  const Mesh& surface;
  const std::vector<VertexMotion>& motions;
  const NearestTriangle& source;
};

/// Found per vertex, not per shell: balls shrink from the farthest offset until nothing of the surface is
/// inside them (by 1 to 2 % of their radius, so that rounding and tessellation do not count).
/// @throws Cancelled if `progress` is cancelled
VertexReach vertexReach(const MovableSurface& moving, const ShellLimits& limits, Progress& progress);

}  // namespace lamina
