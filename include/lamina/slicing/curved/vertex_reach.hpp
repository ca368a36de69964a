// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/spatial/signed_distance.hpp"
#include "lamina/slicing/curved/vertex_motion.hpp"

namespace lamina {

/// The side of a part's surface on which shells stay.
enum class PartSide { Inside, Outside };

/// Limits at which shells end.
struct ShellLimits {
  const SignedDistance* part = nullptr;   ///< part at whose surface shells end; null for none
  PartSide part_side = PartSide::Inside;  ///< side of that surface on which shells stay
  /// The part's surface without the one that is propagated; null for none, or if shells do not end at it.
  const NearestTriangle* rest = nullptr;
  std::optional<ShellBound> bound;  ///< half-space in which shells stay; nothing for all of space
  double farthest_mm = 0.0;         ///< greatest offset that is computed
  /// Distance between the offsets at which paths are tested for leaving the part.
  double step_mm = 0.2;

  /// Signed distance of a point from the part's surface [mm], positive on the side where shells stay; `part`
  /// must not be null.
  double allowed(const Point3& point) const {
    const double inside = part->at(point).inside_mm;
    return part_side == PartSide::Inside ? inside : -inside;
  }
};

/// How far each vertex of a surface can be propagated; the vectors hold one offset per vertex.
struct VertexReach {
  /// Offset [mm] at which the vertex collapses, as it gets nearer to another place of the surface than to its
  /// original place: the radius of the greatest ball that touches the surface at this place from the front.
  /// `farthest_mm` if the vertex does not collapse up to that offset.
  std::vector<double> collapse_mm;
  /// Offset at which the vertex's path first leaves the part [mm]; infinite if it does not.
  std::vector<double> exit_mm;
  /// Offset at which the vertex's path crosses the bound [mm]; infinite if it does not.
  std::vector<double> bound_mm;
};

/// A surface and how its vertices move.
struct MovableSurface {
  const Mesh& surface;                       ///< a subdivision of the source
  const std::vector<VertexMotion>& motions;  ///< one per vertex of `surface`
  const NearestTriangle& source;             ///< the source, for queries
};

/// Computes how far each vertex can be propagated, once for all shells. For the collapse, a ball is shrunk
/// from the farthest offset until none of the surface is inside it, except for 1 to 2 % of its radius, so
/// that rounding and tessellation have no effect.
/// @throws Cancelled if `progress` is cancelled
VertexReach vertexReach(const MovableSurface& moving, const ShellLimits& limits, Progress& progress);

}  // namespace lamina
