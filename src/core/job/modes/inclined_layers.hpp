// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/slicing/slicing_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The plane of the bed in the frame of the layers.
BedPlane bedBelow(const PlaneSettings& plane, const Eigen::Isometry3d& bed_from_part);

/// The toolpath transformed from the frame of its layers to the part frame, where it lies in the inclined
/// planes, with the nozzle as `slicing.plane.tool_axis` says. Level layers are returned unchanged.
Toolpath inPartFrame(Toolpath planned, const PlaneSettings& plane);

/// Refuses inclined layers that a fixed head cannot deposit, before slicing.
/// @throws Unreachable naming the plane that the head is made for, if its nozzle at rest has another angle
///   than the layers need
void requireToolAxis(const PlaneSettings& plane, const BuildSpace& space);

}  // namespace lamina
