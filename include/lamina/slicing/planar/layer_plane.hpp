// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/slicing_settings.hpp"

namespace lamina {

/// The turn by +angle about the axis (right-handed), as the G-code transform turns a program
/// [Garcia2024, eq. 4.1 to 4.3]: layers are level in the frame it comes from, their normal in the part
/// is R z. About x by a: (0, -sin a, cos a), so that layers follow each other towards -y. Identity to the
/// last bit for an angle of 0.
Eigen::Quaterniond partFromLayers(const PlaneSettings& plane);

/// The mesh turned about the origin, in its own memory.
Mesh turned(Mesh mesh, const Eigen::Quaterniond& rotation);

}  // namespace lamina
