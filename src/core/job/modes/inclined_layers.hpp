// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/slicing/slicing_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The bed in the frame of the layers.
BedPlane bedBelow(const PlaneSettings& plane, const Eigen::Isometry3d& bed_from_part);

/// A toolpath that was planned in the frame of its layers, in the part frame: it lies in its inclined planes,
/// with the nozzle as `slicing.plane.tool_axis` says. Level layers stay as they are.
Toolpath inPartFrame(Toolpath planned, const PlaneSettings& plane);

/// Refuses early what a fixed head cannot lay.
/// @throws Unreachable if the nozzle would be held at another angle than the head holds it at rest; names the
/// plane that its angle is for
void requireToolAxis(const PlaneSettings& plane, const BuildSpace& space);

}  // namespace lamina
