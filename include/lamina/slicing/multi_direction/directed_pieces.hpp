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

/// A piece of the part that is printed in plane layers across one direction. Its material lies above its own
/// plane and below the planes of all later pieces.
struct DirectedPiece {
  Point3 up = Point3::UnitZ();   ///< in which its layers follow each other, of unit length [part frame]
  double from_mm = 0.0;          ///< place of its plane along `up`; the bed's for the first piece
  double to_mm = 0.0;            ///< its highest place
  double unsupported_mm2 = 0.0;  ///< surface that overhangs by more than is taken from `up`

  double height() const { return to_mm - from_mm; }
  /// The turn from +z to `up`.
  Eigen::Quaterniond partFromPiece() const;
};

/// A part in pieces, in the order in which they are printed. All that is printed before a piece lies below
/// its plane, so that a head that ends at the nozzle tip is clear of it.
struct DirectedPieces {
  std::vector<DirectedPiece> pieces;  ///< the first stands on the bed, its direction is +z
  double cell_mm = 0.0;
  double surface_mm2 = 0.0;
  double unsupported_level_mm2 = 0.0;    ///< without any cut
  Mesh hanging;                          ///< triangles of what is left unsupported
  double cut_mm2 = 0.0;                  ///< area of all cuts
  std::shared_ptr<const HeadRoom> room;  ///< of the head, over the part as its pieces are printed

  /// Height printed before a piece [mm]: growth, as `room` counts it.
  double growthBefore(std::size_t piece) const;
  double unsupported() const;
};

/// The request by which a part is cut into pieces.
struct DirectionRequest {
  DirectionSettings settings;
  SlicingSettings slicing;
  double bead_mm = 0.4;              ///< width
  std::vector<HeadStage> head = {};  ///< that lays them; none clears everything
};

/// Cuts a part into pieces that leave little of its surface unsupported. Planes are found from the last piece
/// to the first: for each direction the lowest plane above which nothing, or little, overhangs. A beam search
/// minimises the unsupported surface. Each cut adds half a percent of the surface and a hundredth of the
/// cut's area. A cut is taken only if the rest of the part stays connected with the bed, each part of the
/// piece lies on that rest by four bead widths squared, and the head clears the bed over it. A part that
/// level layers print is one piece. The same for any number of threads.
///
/// @param mesh  closed, facing outwards [mm, part frame]; stands on the bed by its lowest place
/// @throws Unsliceable with the surface left unsupported, if it is more than
///         `directions.largest_unsupported_percent`
/// @throws InvalidMesh if the mesh is open or holds no volume; Cancelled
DirectedPieces directedPieces(const Mesh& mesh, const MeshTopology& topology, const DirectionRequest& request,
                              Progress& progress);

/// The layers of a piece in its own frame, turned about the part's origin. Those above the first piece have
/// the common height from their plane on.
/// @throws Cancelled
std::vector<Layer> layersOf(const DirectedPieces& pieces, std::size_t piece, const Mesh& mesh,
                            const SlicingSettings& slicing, Progress& progress);

}  // namespace lamina
