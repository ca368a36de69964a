// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The prism over regions, from z = 0 to `height_mm`: a closed mesh whose triangles face outwards. Its side
/// faces are divided at all points that the triangles of top and bottom have on the border. Empty if there
/// are no regions.
/// @param height_mm  positive
/// @throws InvalidInput if outlines cross (see `triangulated`)
Mesh extruded(const Regions& regions, double height_mm);

}  // namespace lamina
