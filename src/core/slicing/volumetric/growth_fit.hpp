// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/volumetric/volumetric_settings.hpp"
#include "slicing/volumetric/arrival_field.hpp"
#include "slicing/volumetric/cell_graph.hpp"
#include "slicing/volumetric/growth_gauge.hpp"

namespace lamina {

/// Growth of a part, as it arrives.
struct ArrivedGrowth {
  const CellGraph& cells;
  const ArrivalField& field;
  const GrowthGauge& gauge;
};

/// What growth is fitted to.
struct GrowthFitRequest {
  GrowthTarget target = GrowthTarget::Smooth;
  GrowthLimits limits;
  double skin_slope_rad = 0.44;  ///< steepest slope of a skin that layers follow, from their own normal
  double first_layer_mm = 0.2;   ///< height over the bed below which growth stays as it is
  int rounds = 8;                ///< of directions and field in turn; at least 1
  /// Of unit length, at each node of the part, if the target is `Given`; else empty.
  std::vector<Point3> given = {};
  GrowthFoot foot = GrowthFoot::Flat;  ///< if free, growth changes in the first layer too
};

/// Growth whose gradient is as close as possible, by least squares over the part, to wanted directions:
///
/// - `Smooth`: the directions of the arrival field, smoothed over two cells;
/// - `Surface`: the same, but the normal of the surface at skins that face growth;
/// - `Tangent`: along the part, from the bed to its ends: the gradient of the harmonic field that is 0 on the
///   bed and 1 on the flat face at the end of each limb, where the distance from the bed through the part is
///   greatest;
/// - `Given`: the directions of the request.
///
/// Directions are turned so that no surface overhangs them by more than the limit, and no direction tilts by
/// more than the limit. The wanted length of the gradient is that of the arrival field; for `Tangent` it is
/// 1; for `Given` it is that of the previous round's field along the direction, within the bounds of
/// thickness. The result is scaled so that its gradient exceeds 1, where layers are thinner than their
/// nominal height, in at most 0.5 % of the volume. Where fronts of the arrival field meet, the fold between
/// them stays as it is. With a free foot growth begins with 0 at the first place that it reaches of each
/// body. Nodes that no growth reaches stay so. The result may exceed the limits: the caller must check it.
///
/// Source: directions and a Poisson equation in turn, as [Liu2008] alternates local and global steps.
/// @param mesh  closed, facing outwards [mm, part frame]
/// @throws Unsliceable if `Tangent` finds no end; Cancelled
ArrivalField fittedGrowth(const Mesh& mesh, const ArrivedGrowth& arrived, const GrowthFitRequest& request,
                          Progress& progress);

/// A mixture of the arrival field and a fitted one.
/// @param share  of the fitted one, within [0, 1]
ArrivalField blendedGrowth(const ArrivedGrowth& arrived, const ArrivalField& fitted, double share);

}  // namespace lamina
