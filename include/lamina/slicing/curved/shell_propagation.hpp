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

/// On which side of a shell the nozzle is.
enum class NozzleSide {
  Ahead,   ///< where the surface is propagated to: shells are deposited one on the other in the
           ///< order of propagation
  Behind,  ///< where it comes from: shells are deposited in the opposite order
};

/// Which shell of a surface.
struct ShellAt {
  double offset_mm = 0.0;  ///< of its middle from the surface
  double height_mm = 0.2;
  NozzleSide side = NozzleSide::Ahead;
};

/// A place at which part of a surface cannot be propagated further.
struct ShellEnd {
  double offset_mm = 0.0;         ///< the greatest offset there
  Point3 where = Point3::Zero();  ///< the place of the surface that goes farthest [mm]
};

/// Equidistant shells of an open surface, on the side that its triangles face [Guacheta2021,
/// algorithm 2-2]. Each shell is propagated from the surface itself by its whole offset, so that errors do
/// not add up from shell to shell.
class ShellPropagation {
 public:
  /// @param source           its surface faces where its shells are to be
  /// @param longest_edge_mm  longer edges of it are halved first, so that shells can bend and end there
  /// @throws InvalidInput if it has no triangle or the length is not positive; Cancelled
  ShellPropagation(const ShellSource& source, double longest_edge_mm, const ShellLimits& limits,
                   Progress& progress);
  ShellPropagation(const ShellPropagation&) = delete;
  ShellPropagation& operator=(const ShellPropagation&) = delete;

  /// The shell at an offset, without what has collapsed, has left the part or lies beyond the bound; without
  /// triangles if nothing is left. Vertices that have collapsed (past the medial axis) are merged into living
  /// ones near them, so that the shell stays connected along the creases that arise. Where the shell leaves
  /// the part or crosses the bound, it is cut along that line.
  ///
  /// Triangles face as the surface does if the nozzle is ahead, the other way if it is behind; so do normals.
  /// Heights are those asked for, and less where the bound or the part's surface lies ahead by less than half
  /// of that height.
  LayerSurface shell(const ShellAt& at) const;

  /// The shell at the offset `height_mm / 2` and those at every further `height_mm`, up to the last one
  /// before a shell without triangles.
  std::vector<LayerSurface> shells(double height_mm, NozzleSide side, Progress& progress) const;

  /// No shell has triangles at greater offsets.
  double farthest() const;

  /// Where shells of this height end: every place of the surface that goes farther than its surroundings by
  /// more than one height, the farthest first.
  std::vector<ShellEnd> ends(double height_mm) const;

  /// The source with its edges halved.
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
