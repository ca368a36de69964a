// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/adapted/adapted_settings.hpp"
#include "lamina/slicing/slicing_settings.hpp"

namespace lamina {

/// The curve that the nozzle follows along one wall in one layer: a closed loop, or an open piece of one if
/// the wall reaches the top of the part elsewhere. The vectors hold one value per point. Seen from above,
/// outer walls run counter-clockwise and walls of holes clockwise.
struct AdaptedCurve {
  bool is_closed = true;          ///< the last point joins the first, which is not repeated
  std::vector<Point3> points;     ///< positions of the nozzle tip, at the top of the layer [mm, part frame]
  std::vector<Point3> axis;       ///< opposite of the tool axis: upwards along the wall, of unit length
  std::vector<double> height_mm;  ///< height of the bead: distance from the layer below
};

/// Curves of one layer, wall by wall.
struct AdaptedLayer {
  std::vector<AdaptedCurve> curves;
  /// Border of the layer if at least one wall has no closed curve in it: for each wall a loop that consists
  /// of the wall's curves and of pieces of the loop below. Empty if all curves are closed.
  std::vector<AdaptedCurve> outlines;
};

/// Layers that follow leaning walls.
struct AdaptedLayers {
  std::vector<AdaptedLayer> layers;  ///< upwards
  /// Number of layers at the top, from the first that has `outlines` to the last.
  std::size_t completing = 0;
};

/// Slices a part into layers whose height is measured along its walls [Flores2018, section 6.2.3]. Along a
/// leaning wall, plane layers are farther apart than they are high. Each curve is therefore a plane contour
/// that is moved down the wall until it is at most a layer height from the curve below. Where walls lean
/// equally all round, layers stay plane. The gap between the last closed curve and the top of the part is
/// filled by open curves. Ends of open curves with beads lower than a quarter of a layer are left out, and so
/// are curves shorter than a step at the tip of a wall. Seen from above, no curve crosses itself or another
/// curve of its layer.
///
/// Walls are closed loops that neither split nor merge between the part's flat bottom and its top; each is
/// followed independently of the others. The time is n log n in the points of all layers.
///
/// @param mesh  closed, facing outwards [mm, part frame]
/// @return the same for any number of threads
/// @throws Unsliceable with the faces that prevent it, if a wall leans by more than `adapted.max_lean_deg`,
///         splits, merges, begins above the bottom or ends below the top, or if curves of a layer cross
/// @throws InvalidMesh if the mesh is empty or a contour is open
/// @throws InvalidConfig if the smoothing window is even, the computing height is no multiple of the layer
///         height, or there would be more than a million layers
/// @throws Cancelled
AdaptedLayers adaptedLayers(const Mesh& mesh, const SlicingSettings& slicing, const AdaptedSettings& settings,
                            Progress& progress);

}  // namespace lamina
