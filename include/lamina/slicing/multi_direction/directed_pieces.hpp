// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/slicing/multi_direction/direction_settings.hpp"
#include "lamina/slicing/slicing_settings.hpp"
#include "lamina/slicing/volumetric/head_room.hpp"

namespace lamina {

/// A piece of the part that is printed in plane layers normal to one direction. Its material lies above its
/// own plane and below the planes of all later pieces.
struct DirectedPiece {
  Point3 up = Point3::UnitZ();   ///< direction in which its layers are stacked, of unit length [part frame]
  double from_mm = 0.0;          ///< position of its plane along `up`; that of the bed for the first piece
  double to_mm = 0.0;            ///< position of its highest point along `up`
  double unsupported_mm2 = 0.0;  ///< surface that overhangs, against `up`, by more than is allowed

  double height() const { return to_mm - from_mm; }
  /// The rotation from +z to `up`.
  Eigen::Quaterniond partFromPiece() const;
};

/// A part in pieces, in the order in which they are printed. Everything printed before a piece lies below the
/// piece's plane: a head that does not extend beyond the nozzle tip cannot collide with earlier pieces.
struct DirectedPieces {
  std::vector<DirectedPiece> pieces;  ///< the first stands on the bed, its direction is +z
  double cell_mm = 0.0;               ///< side of the voxels in which cuts are searched
  double surface_mm2 = 0.0;
  /// Unsupported surface of the whole part in level layers, without any cut.
  double unsupported_level_mm2 = 0.0;
  Mesh hanging;                          ///< triangles of the surface that is left unsupported
  double cut_mm2 = 0.0;                  ///< area of all cuts
  std::shared_ptr<const HeadRoom> room;  ///< collision check of the head against what is printed before

  /// Sum of the heights of the pieces before a piece [mm]: the growth, as in `HeadRoom`, at which the piece
  /// begins.
  double growthBefore(std::size_t piece) const;
  double unsupported() const;
};

/// The request by which a part is cut into pieces.
struct DirectionRequest {
  DirectionSettings settings;
  SlicingSettings slicing;
  double bead_mm = 0.4;              ///< width of beads
  std::vector<HeadStage> head = {};  ///< stages of the head that prints; none: collisions are not checked
};

/// Cuts a part into pieces that leave little of its surface unsupported. Planes are found from the last piece
/// to the first: for each direction the lowest plane above which nothing, or little, overhangs. A beam search
/// minimises the unsupported surface. Each cut adds half a percent of the surface and a hundredth of the
/// cut's area to the cost of a sequence. A cut is taken only if the rest of the part stays connected with the
/// bed, each connected part of the piece lies on that rest over at least the area of a square of four bead
/// widths, and the head stays clear of the bed while it prints the piece. A part that can be printed in level
/// layers is one piece. The result is the same for any number of threads.
///
/// @param mesh  closed, facing outwards [mm, part frame]; its lowest point is on the bed
/// @throws Unsliceable with the surface left unsupported, if it is more than
///         `directions.largest_unsupported_percent`
/// @throws InvalidMesh if the mesh is open or holds no volume; Cancelled
DirectedPieces directedPieces(const Mesh& mesh, const MeshTopology& topology, const DirectionRequest& request,
                              Progress& progress);

/// The layers of a piece in its own frame, turned about the part's origin. In pieces after the first, the
/// lowest layer is as high as the others.
/// @throws Cancelled
std::vector<Layer> layersOf(const DirectedPieces& pieces, std::size_t piece, const Mesh& mesh,
                            const SlicingSettings& slicing, Progress& progress);

}  // namespace lamina
