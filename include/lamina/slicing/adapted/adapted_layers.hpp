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

/// One loop of a wall, or a piece of one where a layer reaches the top of the part elsewhere. The vectors
/// hold one value per point. Loops of material run counter-clockwise seen from above, holes clockwise.
struct AdaptedCurve {
  bool is_closed = true;          ///< the last point joins the first, which is not repeated
  std::vector<Point3> points;     ///< where the nozzle tip passes, at the top of the layer [mm, part frame]
  std::vector<Point3> axis;       ///< against the tool axis: up along the wall, of unit length
  std::vector<double> height_mm;  ///< distance from the layer below
};

/// Curves of one layer, wall by wall.
struct AdaptedLayer {
  std::vector<AdaptedCurve> curves;
  /// Border of the layer if not every wall has a closed curve in it. For each wall it is a loop of its
  /// curves, joined by pieces of what the wall stands on. Empty if the curves are loops themselves.
  std::vector<AdaptedCurve> outlines;
};

/// Layers that follow walls which lean.
struct AdaptedLayers {
  std::vector<AdaptedLayer> layers;  ///< upwards
  std::size_t completing = 0;        ///< layers from the first on in which not every wall has a closed curve
};

/// Layers of single walls that grow along the tool by the layer height [Flores2018, section 6.2.3]: a bead
/// along a wall that leans rises less than the layer is high, so flat layers of that height would be too far
/// apart along the wall. Each curve is a flat contour drawn down the wall until it is at most a layer's
/// height from the curve below; where walls lean alike all round, layers stay plane. What is left between the
/// last of them and the top of the part is completed by open curves. Ends of open curves that are lower than
/// a quarter of a layer are left out. So are curves shorter than a step at the tip of a wall. No curve
/// crosses itself or another of its layer seen from above.
///
/// Walls are closed loops that neither split nor merge between the part's flat bottom and its top; each is
/// followed by itself. Time is n log n in the points of all layers.
///
/// @param mesh  closed, facing outwards [mm, part frame]
/// @return the same for any number of threads
/// @throws Unsliceable with the faces in the way if a wall leans too far, splits, merges, begins above the
///         bottom or ends below the top, or if curves of a layer cross; InvalidMesh if a contour is open;
///         InvalidConfig if the smoothing window is even or the computing height no multiple of the layer
///         height; Cancelled
AdaptedLayers adaptedLayers(const Mesh& mesh, const SlicingSettings& slicing, const AdaptedSettings& settings,
                            Progress& progress);

}  // namespace lamina
