// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/slicing/slicing_settings.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "lamina/slicing/volumetric/head_room.hpp"
#include "lamina/slicing/volumetric/volumetric_settings.hpp"

namespace lamina {

/// A layer of equal growth: what lies between two amounts of it.
struct VolumetricLayer {
  Layer plane;           ///< growth at which it begins and ends, as heights in the part frame; the section of
                         ///< a layer that is level as a whole, empty otherwise
  LayerSurface surface;  ///< of a layer that is not level; without triangles otherwise

  bool isLevel() const { return surface.middle.triangles.empty(); }
};

/// How good volumetric layers are. Areas and volumes are of the part above the bed.
struct VolumetricMeasures {
  double cell_mm = 0.0;
  std::size_t nodes = 0;           ///< cells, by pieces
  double overhang_used_deg = 0.0;  ///< lowered, if layers would be too thick otherwise
  double contact_mm2 = 0.0;        ///< with the bed
  double tilt_deg = 0.0;           ///< of growth from up, not exceeded in 99.5 % of the volume
  std::size_t level_layers = 0;
  std::size_t pieces = 0;  ///< connected ones, of layers that are not level

  double surface_mm2 = 0.0;
  double unsupported_level_mm2 = 0.0;  ///< overhangs by more than is taken, if all layers were level
  double unsupported_mm2 = 0.0;        ///< the same over these layers
  double pendant_mm3 = 0.0;            ///< to which no growth leads
  double volume_mm3 = 0.0;

  double thinnest = 1.0;          ///< thickness over nominal height, between neighbouring cells, away from
  double thickest = 1.0;          ///< where fronts meet
  double beyond_thickness = 0.0;  ///< share of the volume that is thinner or thicker than allowed by over 2 %
  std::size_t minima = 0;         ///< cells off the bed that grow before all their neighbours: none is right
  double resting = 1.0;           ///< share of the bent layers' area that lies on what is deposited before
  double least_resting = 1.0;     ///< the same of the piece with least
  double open = 0.0;              ///< share of the volume in no layer
  double open_level = 0.0;        ///< the same of the layers that `planar` gives
  double twice = 0.0;             ///< in more than one
  double left_out_mm3 = 0.0;      ///< pieces smaller than a bead's square
  double greatest_lean_deg = 0.0;  ///< of the head from the layers' normals
  double shut = 0.0;               ///< share of the volume where no such lean clears bed and part
};

/// A part in layers of equal growth, in the order in which they are deposited.
struct VolumetricLayers {
  std::vector<VolumetricLayer> layers;
  VolumetricMeasures measures;
  Mesh hanging;                          ///< triangles of the surface that is left unsupported
  std::shared_ptr<const HeadRoom> room;  ///< of the head that was asked for, over the part as it grows
};

/// The request by which a part is cut into layers of equal growth.
struct VolumetricRequest {
  VolumetricSettings settings;
  SlicingSettings slicing;           ///< heights of first layer and others, the least there are
  double bead_mm = 0.4;              ///< width
  std::vector<HeadStage> head = {};  ///< that lays them; none clears everything
};

/// Layers that grow from the bed through the part. They may tilt and be up to `max_thickness` times as high
/// as asked for, so that no underside overhangs by more than `overhang_used_deg` from its own layer's normal.
/// They are level where level layers meet that condition. The tool axis is against the layer's normal. It
/// leans from there towards upright where the head would be in bed or part.
///
/// @param mesh  closed, facing outwards [mm, part frame]; the bed is at its lowest place, or above that by
///              the depth to which it is sunk
/// @throws Unsliceable naming figure, bound and place: contact with the bed below a bead's square, pendants
/// or
///         unsupported surface beyond their limits, a piece that less than half rests; its region is the
///         surface there
/// @throws InvalidMesh if the mesh is open or holds no volume; InvalidConfig; InvalidInput if there are too
/// many
///         cells, or no layer; Cancelled
VolumetricLayers volumetricLayers(const Mesh& mesh, const MeshTopology& topology,
                                  const VolumetricRequest& request, Progress& progress);

}  // namespace lamina
