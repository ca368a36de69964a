// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/voids/beads/void_class.hpp"
#include "lamina/voids/drops/drop_layer.hpp"
#include "lamina/voids/drops/drop_void_settings.hpp"

namespace lamina {

/// A void between drops, and the drops that fill it.
struct DropVoid {
  VoidClass kind = VoidClass::Between;
  std::vector<VoidPoint> points;       ///< points of the void, those found by later passes last
  double greatest_clearance_mm = 0.0;  ///< of its points
  std::vector<Point2> drops;           ///< new drops, in the order of deposition [mm]
  double uncovered_before_mm2 = 0.0;   ///< uncovered area of the part within the clearance of its points
  double uncovered_after_mm2 = 0.0;    ///< what remains of that area after the new drops of all voids
};

/// Finds the voids of a layer and fills them one by one [Sobreviela2014, section 4.1]. The points of a void
/// are ordered into a line that starts at the point farthest from their middle and always continues to the
/// nearest remaining point. Along that line a drop is placed at each point that is at least `leastDistance`
/// from all new drops before it; all points keep this distance from prior drops. A layer without contours has
/// no inside and gets no drops.
/// @return the voids by the x, then y, of their first points; those found by later passes last
/// @throws InvalidInput if the diameter is not positive
std::vector<DropVoid> fillDropVoids(const DropLayer& layer, const DropVoidSettings& settings);

/// The new drops of all voids, void by void [mm].
std::vector<Point2> newDrops(const std::vector<DropVoid>& voids);

}  // namespace lamina
