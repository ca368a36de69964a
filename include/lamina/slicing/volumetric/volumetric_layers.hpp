// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/slicing/slicing_settings.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "lamina/slicing/volumetric/direction_samples.hpp"
#include "lamina/slicing/volumetric/head_room.hpp"
#include "lamina/slicing/volumetric/volumetric_settings.hpp"

namespace lamina {

// Growth is a scalar field in the part: the height deposited, layer upon layer, when a point is reached [mm].
// It is 0 at the bed. Layers are bounded by its level sets.

/// A layer between two values of growth.
struct VolumetricLayer {
  /// Growth at which the layer begins and ends, as heights in the part frame; with its section if the whole
  /// layer is level.
  Layer plane;
  LayerSurface surface;  ///< surface of a layer that is not level; without triangles otherwise

  bool isLevel() const { return surface.middle.triangles.empty(); }
};

/// Measures of the quality of volumetric layers. Areas and volumes are of the part above the bed.
struct VolumetricMeasures {
  double cell_mm = 0.0;   ///< side of the cells in which growth is computed
  std::size_t nodes = 0;  ///< number of cells; a cell with several pieces of the part counts once per piece
  double overhang_used_deg = 0.0;  ///< angle used for `VolumetricSettings::overhang_used_deg`
  double fitted = 0.0;             ///< share of the growth that is fitted to `VolumetricSettings::target`
  std::string fit_loss;            ///< reason why no larger share is fitted; empty if all growth is fitted
  double contact_mm2 = 0.0;        ///< area of contact with the bed
  /// Angle of the gradient of growth from the vertical, not exceeded in 99.5 % of the volume.
  double tilt_deg = 0.0;
  std::size_t level_layers = 0;  ///< number of level layers
  std::size_t pieces = 0;        ///< number of connected pieces of the layers that are not level

  double surface_mm2 = 0.0;            ///< area of the part's surface
  double unsupported_level_mm2 = 0.0;  ///< area that would overhang by more than allowed from level layers
  double unsupported_mm2 = 0.0;        ///< area that overhangs by more than allowed from these layers
  double pendant_mm3 = 0.0;  ///< volume of pendants: material that growth from the bed does not reach
  double volume_mm3 = 0.0;   ///< volume of the part

  double thinnest = 1.0;  ///< least thickness over nominal height, except where growth from two sides meets
  double thickest = 1.0;  ///< greatest thickness over nominal height, with the same exception
  double beyond_thickness = 0.0;  ///< share of the volume that is thinner or thicker than allowed by over 2 %
  std::size_t minima = 0;  ///< cells off the bed that are reached before all their neighbours; should be 0
  double resting = 1.0;    ///< share of the area of non-level layers that lies on earlier material
  double least_resting = 1.0;  ///< the same share for the piece that rests least
  double open = 0.0;           ///< share of the volume in no layer
  double open_level = 0.0;     ///< share of the volume that would be in no layer of the mode `planar`
  double twice = 0.0;          ///< share of the volume in more than one layer
  /// Volume of pieces left out since they are smaller than a bead's width squared.
  double left_out_mm3 = 0.0;
  double greatest_lean_deg = 0.0;  ///< greatest angle of the tool axis from the layers' normals
  double shut = 0.0;  ///< share of the volume where the head collides with bed or part at any allowed angle
};

/// A part in layers of equal growth, in the order in which they are deposited.
struct VolumetricLayers {
  std::vector<VolumetricLayer> layers;
  VolumetricMeasures measures;
  Mesh hanging;                          ///< triangles of the surface that is left unsupported
  std::shared_ptr<const HeadRoom> room;  ///< collision check of the request's head
};

/// The request by which a part is cut into layers of equal growth.
struct VolumetricRequest {
  VolumetricSettings settings;
  SlicingSettings slicing;           ///< its layer heights are the least thickness of the layers
  double bead_mm = 0.4;              ///< width of beads
  std::vector<HeadStage> head = {};  ///< stages of the head that prints; none: collisions are not checked
  /// Directions to which layers are to be normal, if `VolumetricSettings::target` is `Given` [part frame].
  std::vector<DirectionSample> directions = {};
};

/// Cuts a part into layers that grow from the bed through the part. Layers may tilt, and be up to
/// `max_thickness` times as thick as the layer height, so that no underside overhangs by more than
/// `overhang_used_deg` from the normal of its own layer. They are level where level layers meet that
/// condition. The tool axis is opposite to the normal of the layer, but leans from there towards the vertical
/// where the head would otherwise collide with the bed or the part.
///
/// @param mesh  closed, facing outwards [mm, part frame]; the bed is `sink_mm` above its lowest point
/// @throws Unsliceable naming value, limit and place, if the contact with the bed is smaller than a bead's
///         width squared, pendants or unsupported surface exceed their limits, or less than half of a piece
///         rests on earlier material; the region is the surface there
/// @throws InvalidMesh if the mesh is open or encloses no volume
/// @throws InvalidInput if there are too many cells, or no layer, or as `directionsAtNodes` with given
///         directions; InvalidConfig; Cancelled
VolumetricLayers volumetricLayers(const Mesh& mesh, const MeshTopology& topology,
                                  const VolumetricRequest& request, Progress& progress);

}  // namespace lamina
