// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/slicing/curved/vertex_motion.hpp"
#include "lamina/slicing/curved/vertex_neighbours.hpp"
#include "lamina/slicing/curved/vertex_reach.hpp"

namespace lamina {

struct MergedVertices;

/// The side of a shell on which the nozzle is while it deposits the shell.
enum class NozzleSide {
  Ahead,   ///< the side that faces away from the surface: shells are deposited in the order of propagation
  Behind,  ///< the side that faces the surface: shells are deposited in the opposite order
};

/// Selects a shell of a surface.
struct ShellAt {
  double offset_mm = 0.0;  ///< distance of the middle of the shell from the surface
  double height_mm = 0.2;  ///< thickness of the shell
  NozzleSide side = NozzleSide::Ahead;
};

/// A place beyond which part of a surface cannot be propagated.
struct ShellEnd {
  double offset_mm = 0.0;         ///< greatest offset that is reached
  Point3 where = Point3::Zero();  ///< point of the surface that is propagated farthest [mm]
};

/// Equidistant shells of an open surface, on the side that its triangles face [Guacheta2021, algorithm 2-2].
/// Each shell is propagated from the surface itself by its whole offset, so that errors do not accumulate
/// from shell to shell.
class ShellPropagation {
 public:
  /// @param source           its surface must face the side on which shells are wanted
  /// @param longest_edge_mm  length above which edges of the surface are halved first: shells can then bend
  ///   and end between its vertices
  /// @throws InvalidInput if the surface has no triangle or the length is not positive; Cancelled
  ShellPropagation(const ShellSource& source, double longest_edge_mm, const ShellLimits& limits,
                   Progress& progress);
  ShellPropagation(const ShellPropagation&) = delete;
  ShellPropagation& operator=(const ShellPropagation&) = delete;

  /// The shell at an offset; without triangles if nothing is left of it. Parts that have collapsed, or lie
  /// outside of the part or beyond the bound, are left out. Vertices that have collapsed (passed the medial
  /// axis) are merged into others nearby that have not, so that the shell stays connected along the creases
  /// that arise. The shell is cut along the line where it leaves the part or crosses the bound.
  ///
  /// With the nozzle ahead, triangles and normals face as the surface does; with the nozzle behind, they face
  /// the other way. The height of the shell is that of `at`, or less where the bound or the part's surface is
  /// ahead by less than half of that height.
  LayerSurface shell(const ShellAt& at) const;

  /// The shells at the offsets `height_mm` / 2, 3 `height_mm` / 2 and so on, up to the last one before the
  /// first without triangles.
  std::vector<LayerSurface> shells(double height_mm, NozzleSide side, Progress& progress) const;

  /// The offset [mm] beyond which shells have no triangles.
  double farthest() const;

  /// The places where shells of this height end, the farthest first: each place of the surface that is
  /// propagated farther than its surroundings by more than one height.
  std::vector<ShellEnd> ends(double height_mm) const;

  /// The surface of the source, with its long edges halved.
  const Mesh& surface() const { return subdivision_.mesh; }

 private:
  struct Assembled {
    LayerSurface shell;
    std::vector<std::uint32_t> origin;  // the vertex of the surface whose place each vertex takes
  };

  double reachOf(std::uint32_t vertex) const;
  double aheadOf(std::uint32_t vertex, const ShellAt& at) const;
  bool isEquidistant(const Triangle& corner, const Triangle& root, const MergedVertices& merged,
                     const ShellAt& at) const;
  Assembled assembled(const MergedVertices& merged, const ShellAt& at) const;

  Mesh source_;
  NearestTriangle nearest_;
  Subdivision subdivision_;
  ShellLimits limits_;
  std::vector<VertexMotion> motions_;
  VertexReach reach_;
  VertexNeighbours neighbours_;
};

}  // namespace lamina
