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
  Halves,     ///< the same without level layers: both surfaces overlap in height and are parted half way
  LowerOnly,  ///< shells of all surfaces that face down, up to the upper surface
};

/// In words: "both sides", "halves", "lower only".
const char* toString(CurvedScheme scheme);

/// What the layers fill against what the part holds [mm³].
struct LayerVolumes {
  double part_mm3 = 0.0;
  double lower_mm3 = 0.0;
  double middle_mm3 = 0.0;
  double upper_mm3 = 0.0;
  /// What is left open, of the part's volume; negative if more is deposited than the part holds.
  double gap() const { return 1.0 - (lower_mm3 + middle_mm3 + upper_mm3) / part_mm3; }
};

/// How evenly layers fill a part, by samples inside it. Holes and overlaps cannot cancel here, as they can in
/// volumes.
struct LayerCoverage {
  std::size_t samples = 0;
  double open = 0.0;   ///< share of samples in no layer
  double twice = 0.0;  ///< share of samples in more than one
  /// Greatest connected volume in no layer: samples are connected if they are no farther apart than 1.25
  /// times their spacing. Fewer than four of them, of about 1/4000 of the part each, are put down to chance.
  double void_mm3 = 0.0;
};

/// A part in curved layers, all in the order in which they are deposited: lower, middle, upper.
struct CurvedLayers {
  CurvedScheme scheme = CurvedScheme::BothSides;
  std::vector<LayerSurface> lower;  ///< outermost first
  std::vector<Layer> middle;        ///< level, with what the planes cut out
  std::vector<LayerSurface> upper;  ///< innermost first
  std::vector<ShellEnd> lower_ends;
  std::vector<ShellEnd> upper_ends;
  LayerVolumes volumes;
  LayerCoverage coverage;
};

/// Lower and upper shells with level layers between them [Guacheta2021, algorithm 2-3]. Where the
/// lower surface ends below the upper one's beginning, both are propagated inwards, kept below and above
/// those heights, and level layers fill what is between. Where they overlap in height, shells of everything
/// that faces down go up to the upper surface; if those do not fill the part, both surfaces' shells meet half
/// way.
///
/// @param mesh             closed, facing outwards [mm, part frame]
/// @param layer_height_mm  of every shell; of level layers as near to it as they fit
/// @throws Unsliceable if all of that leaves open or lays twice more than `largest_gap_percent` of the part,
///                     or leaves a void larger than `largest_void_mm3`: names the reason, its region is the
///                     surface nearest to it
/// @throws InvalidMesh if the mesh is open or holds no volume; InvalidConfig; Cancelled
CurvedLayers curvedLayers(const Mesh& mesh, const MeshTopology& topology, const CurvedSettings& settings,
                          double layer_height_mm, Progress& progress);

/// Level layers between two heights, cut at low + h/2, ..., high - h/2 in equal steps [Guacheta2021,
/// listing A.7] if these are within 5 % of h; otherwise, in thin plates, as many of equal height as fit best.
/// None in less than half a height.
std::vector<LayerBounds> middleBounds(double low_mm, double high_mm, double layer_height_mm);

}  // namespace lamina
