// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/slicing/vertex_motion.hpp"
#include "lamina/surface/signed_distance.hpp"

namespace lamina {

/// What ends a shell.
struct ShellLimits {
  const SignedDistance* part = nullptr;  ///< shells stay inside it; nowhere an end if null
  std::optional<ShellBound> bound;       ///< shells stay on its side
  double farthest_mm = 0.0;              ///< no offset beyond it is asked for
  double step_mm = 0.2;                  ///< between the offsets at which leaving the part is looked for
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

/// Of the vertices of `surface`, which may be subdivided from `source`. Found per vertex, not per shell:
/// balls shrink from the farthest offset until nothing of the surface is inside them (by 1 % of their radius,
/// so that rounding and tessellation do not count).
/// @throws Cancelled if `progress` is cancelled
VertexReach vertexReach(const Mesh& surface, const Mesh& source, const std::vector<VertexMotion>& motions,
                        const ShellLimits& limits, Progress& progress);

}  // namespace lamina
