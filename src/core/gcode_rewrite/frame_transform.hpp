// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/program/program_frame.hpp"
#include "gcode_rewrite/point_transform.hpp"

namespace lamina {

/// What the transformed program is to tell of layers, nozzle and axes. Layers and nozzle turn with the map;
/// where it is no rotation, by the smallest turn that brings the normal of the layers to where the map brings
/// the layers. The turn about normal and jet is free: none where these are straight. A map that bends layers
/// leaves nothing to tell.
/// @param source  what the program tells that is transformed
/// @param jet     of a nozzle that is held some way by the machine
ToldFrame transformedFrame(const ToldFrame& source, const PointTransform& transform,
                           const std::optional<Point3>& jet);

/// Angle between the nozzle's axis and the normal of the layers [deg], 0 to 180.
double jetOffNormalDeg(const ToldFrame& frame);

}  // namespace lamina
