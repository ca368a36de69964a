// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Why a position is out of the range of a build space: the first axis out of its range, its value and its
/// limits; empty if all axes are within. An endless axis has a lower limit only.
/// @param values  of the axes [mm]
std::string rangeFault(const BuildSpace& space, const Point3& values, double tolerance_mm);

/// Checks that the head reaches every position of the tip, and that every tool axis is that of the head at
/// rest. The rotation about the tool axis is free.
/// @param bed_from_part  [mm]
/// @param tool_offsets_mm  offsets of the tools' tips from the tip of tool 0, by number of the tool [bed
///   frame]; the head moves by the opposite of the offset; tools beyond the list have no offset
/// @throws Unreachable naming layer, path and waypoint of the first fault: with axis, value and limits, and
///   the tool if it has an offset, if a tip is outside; with the angle if the tool axis deviates by more than
///   0.01 deg from that of the head at rest
void requireReachable(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                      const BuildSpace& space, const std::vector<Point3>& tool_offsets_mm = {});

/// Checks that every position of the tip is in the build space, for any direction of the tool axis.
/// @throws Unreachable as above if a tip is outside
void requireTipsReachable(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                          const BuildSpace& space);

/// Greatest angle between a tool axis of the toolpath and that of the head at rest [rad].
double greatestToolAxisTurn(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                            const BuildSpace& space);

}  // namespace lamina
