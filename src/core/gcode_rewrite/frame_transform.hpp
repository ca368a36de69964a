// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "gcode_rewrite/point_transform.hpp"
#include "lamina/program/program_frame.hpp"

namespace lamina {

/// What the transformed program states about layers, nozzle and axes. Layers and nozzle turn with the map;
/// where it is no rotation, by the smallest turn that brings the normal of the layers to where the map brings
/// the layers. The turn about normal and tool axis is free: none where these are straight. A map that bends
/// layers leaves nothing to state.
/// @param source     what the source program states
/// @param tool_axis  of a nozzle whose direction is fixed by the machine
StatedFrame transformedFrame(const StatedFrame& source, const PointTransform& transform,
                             const std::optional<Point3>& tool_axis);

/// Angle between the nozzle's axis and the normal of the layers [deg], 0 to 180.
double toolAxisOffNormalDeg(const StatedFrame& frame);

}  // namespace lamina
