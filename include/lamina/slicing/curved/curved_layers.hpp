// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/slicing/curved/curved_settings.hpp"
#include "lamina/slicing/curved/shell_propagation.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/slicing/unsliceable.hpp"

namespace lamina {

/// How curved layers divide a part.
enum class CurvedScheme {
  BothSides,  ///< shells of the lower surface, level layers, shells of the upper surface
  Halves,     ///< shells of both surfaces, which overlap in height, up to the level half way between them
  LowerOnly,  ///< shells of all surfaces that face down, up to the upper surface
};

/// The scheme in words: "both sides", "halves", "lower only".
const char* toString(CurvedScheme scheme);

/// Volumes of a part and of its curved layers.
struct LayerVolumes {
  double part_mm3 = 0.0;
  double lower_mm3 = 0.0;   ///< volume of the lower shells
  double middle_mm3 = 0.0;  ///< volume of the level layers
  double upper_mm3 = 0.0;   ///< volume of the upper shells
  /// Share of the part's volume that the layers lack; negative if they have more volume than the part.
  double gap() const { return 1.0 - (lower_mm3 + middle_mm3 + upper_mm3) / part_mm3; }
};

/// How evenly layers fill a part, by sample points inside it. Unlike in `LayerVolumes`, holes and overlaps
/// cannot cancel.
struct LayerCoverage {
  std::size_t samples = 0;  ///< number of sample points
  double open = 0.0;        ///< share of samples in no layer
  double twice = 0.0;       ///< share of samples in more than one layer
  /// Volume of the greatest void: a group of samples in no layer, connected over distances of at most 1.25
  /// times the spacing of the samples. A sample stands for about 1/4000 of the part; groups of fewer than
  /// four samples are ignored as chance.
  double void_mm3 = 0.0;
};

/// A part in curved layers, in the order of deposition: lower, middle, upper.
struct CurvedLayers {
  CurvedScheme scheme = CurvedScheme::BothSides;
  std::vector<LayerSurface> lower;   ///< shells of the lower surface, outermost first
  std::vector<Layer> middle;         ///< level layers, upwards
  std::vector<LayerSurface> upper;   ///< shells of the upper surface, innermost first
  std::vector<ShellEnd> lower_ends;  ///< places where the lower shells end, the farthest first
  std::vector<ShellEnd> upper_ends;  ///< places where the upper shells end, the farthest first
  LayerVolumes volumes;
  LayerCoverage coverage;
};

/// Divides a part into shells of its lower surface, level layers, and shells of its upper surface
/// [Guacheta2021, algorithm 2-3]. If the top of the lower surface is below the bottom of the upper surface,
/// both are propagated inwards, up to these two heights, and level layers fill the space between. If the two
/// surfaces overlap in height, shells of all faces that face down are propagated up to the upper surface; if
/// these shells do not fill the part, shells of both surfaces meet half way.
///
/// @param mesh             closed, facing outwards [mm, part frame]
/// @param layer_height_mm  height of every shell; level layers are as close to this height as fits
/// @throws Unsliceable naming the reason, if no surface faces down or none up, or if in every scheme more
///                     than `largest_gap_percent` of the part is in no layer or in more than one, or a void
///                     is larger than `largest_void_mm3`; the region is the surface nearest to the fault
/// @throws InvalidMesh if the mesh is open or encloses no volume; InvalidConfig; Cancelled
CurvedLayers curvedLayers(const Mesh& mesh, const MeshTopology& topology, const CurvedSettings& settings,
                          double layer_height_mm, Progress& progress);

/// The level layers between two heights. With h the layer height, they are cut at low + h/2, ..., high - h/2
/// in equal steps [Guacheta2021, listing A.7], if these steps are within 5 % of h. Otherwise, in thin plates,
/// they are of equal height, as many as come nearest to h. Empty if there is less than half a layer height.
std::vector<LayerBounds> middleBounds(double low_mm, double high_mm, double layer_height_mm);

}  // namespace lamina
