// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A box around a piece of deposited material [bed frame].
struct DepositedBox {
  Point3 middle = Point3::Zero();
  Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();  ///< x along the bead, z away from the layer
  Eigen::Vector3f size = Eigen::Vector3f::Zero();
  WaypointIndex deposited;

  Eigen::Isometry3d pose() const;
};

/// All boxes of a toolpath in the order in which they are deposited.
struct DepositedBoxes {
  std::vector<DepositedBox> boxes;
  std::vector<std::size_t> before_layer;  ///< for each layer the number of boxes deposited before it
};

/// Makes the boxes of a toolpath. A box extends downwards from the nozzle tip along the layers' normal, or,
/// if layers are not plane, along the tool axis. Long beads are divided into pieces of about ten widths, so
/// that the boxes around them stay small. Beads that vanish once the tolerance is taken off are no obstacles.
/// @param tolerance_mm  taken off the top and both flanks of each bead
DepositedBoxes depositedBoxes(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                              double tolerance_mm);

/// Number of boxes that are deposited on the motion to a waypoint, or as the drop at it; 0 for waypoint 0 of
/// an open path of beads.
std::size_t piecesDepositedAt(const Path& path, std::size_t waypoint, double tolerance_mm);

}  // namespace lamina
