// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Leads travels so that an endless belt never runs back: it slips, or marks the part, where it does. Along a
/// way from bead to bead the belt moves on at most as far as the next bead needs, as soon as the way rises by
/// as much, and not back. The gantry lies in the layers, so that only the belt could lift the nozzle off one:
/// within a layer travels do not hop, and on their way to the next layer they pass over the last one by the
/// height of the next. Where the nozzle waits on its way, it goes up the gantry as far as the belt does not
/// lift it; its dwell takes the time that the way is shorter. Without effect on machines without a belt, and
/// on layers that are not plane or within which the belt moves. Ways with a scan stay too: from its layer the
/// sensor stands off by the belt.
/// @param limits             of the times of ways
/// @param scan_clearance_mm  of the heights of scans (`scanHeight`); none if no layer is scanned
void keepBeltForward(Toolpath& toolpath, const BuildSpace& space, const Eigen::Isometry3d& bed_from_part,
                     const MotionLimits& limits, std::optional<double> scan_clearance_mm = std::nullopt);

}  // namespace lamina
