// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A piece of a link as it is looked at.
struct SeenBody {
  std::string link;
  Mesh mesh;                                       ///< [mm, frame of the link]
  std::array<double, 3> colour{0.62, 0.64, 0.67};  ///< red, green, blue of its material, grey without one
};

/// The `<visual>` elements of all links, by the names of the links; of a link without any its `<collision>`
/// elements.
/// @throws InvalidConfig if it is no URDF; as `linkBodies`
std::vector<SeenBody> seenBodies(const std::string& urdf);

}  // namespace lamina
