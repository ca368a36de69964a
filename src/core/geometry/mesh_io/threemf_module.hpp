// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh_io/mesh_objects.hpp"

namespace lamina {

/// What the module `threemf` offers: lib3mf stays out of commands that read no 3MF.
struct ThreemfModule {
  Mesh (*read)(std::string_view bytes, const std::string& name);  ///< as `readThreemf`
  /// The same by items of the build list.
  std::vector<MeshObject> (*read_objects)(std::string_view bytes, const std::string& name);
  /// Volumes of all items that say how the part is printed. Costs little where there are none.
  std::vector<MeshVolume> (*read_volumes)(std::string_view bytes, const std::string& name);
};

}  // namespace lamina
