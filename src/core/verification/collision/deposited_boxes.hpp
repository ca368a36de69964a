// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A piece of deposited material [bed frame].
struct DepositedBox {
  Point3 middle = Point3::Zero();
  Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();  ///< x along the bead, z off the layer
  Eigen::Vector3f size = Eigen::Vector3f::Zero();
  WaypointIndex deposited;

  Eigen::Isometry3d pose() const;
};

/// All boxes of a toolpath in the order in which they are deposited.
struct DepositedBoxes {
  std::vector<DepositedBox> boxes;
  std::vector<std::size_t> before_layer;  ///< how many are deposited before each layer
};

/// A box lies below the nozzle tip along the layers' normal; on layers that are not plane, along the tool
/// axis. Long beads are cut into pieces of about ten widths, so that boxes round them are small too. Beads
/// that the tolerance leaves nothing of are no obstacles.
/// @param tolerance_mm  taken off the top and both flanks
DepositedBoxes depositedBoxes(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                              double tolerance_mm);

/// How many boxes are deposited on the way to the waypoint, or are the drop at it; waypoint 0 of an open path
/// of beads has none.
std::size_t piecesDepositedAt(const Path& path, std::size_t waypoint, double tolerance_mm);

}  // namespace lamina
