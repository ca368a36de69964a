// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/slicing_settings.hpp"

namespace lamina {

/// The rotation from the frame in which the layers are level to the part frame: by the angle of the settings
/// about their axis, right-handed, as the G-code transform rotates a program [Garcia2024, eq. 4.1 to 4.3].
/// The normal of the layers in the part frame is the rotated z axis; for an angle a about x it is (0, -sin a,
/// cos a), so that layers are stacked towards -y. Exactly the identity for an angle of 0.
Eigen::Quaterniond partFromLayers(const PlaneSettings& plane);

/// The mesh rotated about the origin.
Mesh turned(Mesh mesh, const Eigen::Quaterniond& rotation);

}  // namespace lamina
