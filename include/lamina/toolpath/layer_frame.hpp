// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Whether the layers are inclined against the xy plane of the part frame by more than 1e-9 rad.
bool isInclined(const Toolpath& toolpath);

/// Whether all paths that deposit lie in the planes of their layers, within 1e-6 mm.
bool hasPlaneLayers(const Toolpath& toolpath);

/// Angle between the layers and the xy plane of the part frame [deg], 0 to 180.
double inclinationDeg(const Toolpath& toolpath);

/// Direction in which the layers are stacked, of unit length [part frame].
Point3 layerNormal(const Toolpath& toolpath);

/// The toolpath rotated about the origin: points, orientations and the frame of the layers.
Toolpath turned(Toolpath toolpath, const Eigen::Quaterniond& rotation);

/// The toolpath transformed to another frame, for example that of the bed.
/// @param frame_from_part  translation [mm]
Toolpath placed(const Toolpath& toolpath, const Eigen::Isometry3d& frame_from_part);

/// The toolpath rotated so that its layers are level: every waypoint of a plane layer has the z `z_mm`.
Toolpath inLayerFrame(Toolpath toolpath);

/// The toolpath with the same orientation of the nozzle at all waypoints.
/// @param part_from_nozzle  of unit length
Toolpath withNozzle(Toolpath toolpath, const Eigen::Quaterniond& part_from_nozzle);

/// Refuses a toolpath with inclined layers, for functions that need level ones.
/// @param who  beginning of the message: "the height monitor"
/// @throws InvalidInput if the layers are inclined, giving their angle
void requireLevelLayers(const Toolpath& toolpath, const std::string& who);

}  // namespace lamina
