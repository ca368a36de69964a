// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh_io/mesh_objects.hpp"

namespace lamina {

/// Functions of the module `threemf`, which keeps lib3mf out of commands that read no 3MF file.
struct ThreemfModule {
  Mesh (*read)(std::string_view bytes, const std::string& name);  ///< as `readThreemf`
  /// Reads the items of the build list one by one.
  std::vector<MeshObject> (*read_objects)(std::string_view bytes, const std::string& name);
  /// Reads the volumes of all items that state how the part is printed. Takes little time if there are none.
  std::vector<MeshVolume> (*read_volumes)(std::string_view bytes, const std::string& name);
};

}  // namespace lamina
