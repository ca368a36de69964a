// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Checks that every tip of a toolpath is in the build space, and that each tool axis is that of the head at
/// rest. The turn about the tool axis is free.
/// @param bed_from_part  [mm]
/// @throws Unreachable if a tip is outside (gives axis, value and limits), or the tool axis is another than
///   that of the head at rest by more than 0.01 deg (gives the angle); names layer, path and waypoint of the
///   first
void requireReachable(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                      const BuildSpace& space);

/// The same for the nozzle tip alone, whichever way the tool axis points.
/// @throws Unreachable as above if a tip is outside
void requireTipsReachable(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                          const BuildSpace& space);

/// Greatest angle between a tool axis of the toolpath and that of the head at rest [rad].
double greatestToolAxisTurn(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                            const BuildSpace& space);

}  // namespace lamina
