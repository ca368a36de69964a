// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A piece of a link as it is displayed.
struct DisplayBody {
  std::string link;
  Mesh mesh;  ///< [mm, frame of the link]
  /// Red, green and blue of its material, 0 to 1; grey without one.
  std::array<double, 3> colour{0.62, 0.64, 0.67};
};

/// The `<visual>` elements of all links, in order of the links' names. A link without any is displayed by its
/// `<collision>` elements.
/// @throws InvalidConfig if it is no URDF; as `linkBodies`
std::vector<DisplayBody> displayBodies(const std::string& urdf);

}  // namespace lamina
