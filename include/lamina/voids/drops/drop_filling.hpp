// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/voids/beads/void_class.hpp"
#include "lamina/voids/drops/drop_layer.hpp"
#include "lamina/voids/drops/drop_void_settings.hpp"

namespace lamina {

/// A void between drops and what filled it.
struct DropVoid {
  VoidClass kind = VoidClass::Between;
  std::vector<VoidPoint> points;  ///< that mark it; those of a later pass behind those of the first
  double greatest_clearance_mm = 0.0;
  std::vector<Point2> drops;          ///< new ones, in the order they are deposited
  double uncovered_before_mm2 = 0.0;  ///< of the material within the clearance of its points
  double uncovered_after_mm2 = 0.0;   ///< of that, left by the new drops of all voids
};

/// Finds the voids of a layer and fills each by itself [Sobreviela2014, section 4.1]: the points of a void
/// are ordered into a line that starts at the point farthest from their middle and always goes on to the
/// nearest point. Along that line a drop is deposited wherever it keeps its distance to all others. A layer
/// without a contour has no inside and gets no drops.
/// @return in the order of their first points by x, then y; those found by later passes behind
/// @throws InvalidInput if the diameter is not positive
std::vector<DropVoid> fillDropVoids(const DropLayer& layer, const DropVoidSettings& settings);

/// New drops of all voids, void by void.
std::vector<Point2> newDrops(const std::vector<DropVoid>& voids);

}  // namespace lamina
