// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "gcode_rewrite/point_transform.hpp"
#include "lamina/program/program_frame.hpp"

namespace lamina {

/// The frame that the transformed program states for layers, nozzle and axes. A map that is a rotation turns
/// layers and nozzle. Any other linear map turns them by the least rotation that brings the normal of the
/// source layers to that of the mapped layers. Rotation about normal and tool axis is free: it is zero if
/// these are straight up and down. A map that bends layers leaves nothing to state.
/// @param source     what the source program states
/// @param tool_axis  direction of a nozzle that is fixed by the machine
StatedFrame transformedFrame(const StatedFrame& source, const PointTransform& transform,
                             const std::optional<Point3>& tool_axis);

/// Angle between the tool axis and the normal of the layers [deg], 0 to 180.
double toolAxisOffNormalDeg(const StatedFrame& frame);

}  // namespace lamina
