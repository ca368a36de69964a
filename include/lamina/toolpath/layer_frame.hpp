// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Whether the layers are other than level, by more than 1e-9 rad.
bool isInclined(const Toolpath& toolpath);

/// Whether all that is deposited lies in the planes of its layers, within 1e-6 mm.
bool hasPlaneLayers(const Toolpath& toolpath);

/// Angle between the layers and the level plane of the part's frame [deg], 0 to 180.
double inclinationDeg(const Toolpath& toolpath);

/// Direction in which the layers follow each other, of unit length [part frame].
Point3 layerNormal(const Toolpath& toolpath);

/// The toolpath turned about the origin: points, nozzle and layers. Lengths, beads and feeds stay.
Toolpath turned(Toolpath toolpath, const Eigen::Quaterniond& rotation);

/// The toolpath in another frame, say that of the bed.
/// @param frame_from_part  translation [mm]
Toolpath placed(const Toolpath& toolpath, const Eigen::Isometry3d& frame_from_part);

/// The toolpath turned so that its layers are level: every waypoint of a planar layer is at its `z_mm`.
Toolpath inLayerFrame(Toolpath toolpath);

/// The toolpath with its nozzle held one way at all waypoints.
/// @param part_from_nozzle  of unit length
Toolpath withNozzle(Toolpath toolpath, const Eigen::Quaterniond& part_from_nozzle);

/// For what looks at layers from above and cannot do with others.
/// @param who  begins the message: "the height monitor"
/// @throws InvalidInput if the layers are inclined, giving their angle
void requireLevelLayers(const Toolpath& toolpath, const std::string& who);

}  // namespace lamina
