// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/control/cell_estimate.hpp"
#include "lamina/control/layer_cells.hpp"
#include "lamina/control/run/layer_progress.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Width of a layer's widest bead [mm]; 0 without cells.
double widestBead(const LayerCells& cells);

/// The cell of a layer on which the nozzle is; none on a path without cells.
std::optional<std::size_t> cellAt(const LayerCells& cells, const PrintPosition& place);

/// Height of the highest known cell above the planned ground of its layer [mm]; -1e9 if none is known.
double highestCell(const std::vector<CellEstimate>& estimates);

/// The area over which a layer lies, widened by the width of its beads [mm]: the bounding box of its cells'
/// middles, projected along the layers' normal onto the plane through the origin.
Box3 groundOf(const LayerCells& cells, const Eigen::Vector3d& normal);

/// Heights of the points of a profile over a plane of the layers' normal [mm]; not finite for a missing
/// point, or one outside that area.
/// @param level_mm  of the plane, over the origin
/// @param points    [mm, frame of the sensor]
std::vector<double> heightsOver(double level_mm, const Box3& ground, const Eigen::Vector3d& normal,
                                const std::vector<Point3>& points,
                                const Eigen::Isometry3d& toolpath_from_sensor);

}  // namespace lamina
