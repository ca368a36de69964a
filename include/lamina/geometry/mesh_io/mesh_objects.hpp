// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/geometry/mesh_io/mesh_reader.hpp"

namespace lamina {

/// One of the objects that a file tells apart.
struct MeshObject {
  std::string name;  ///< empty if the file gives none
  Mesh mesh;
};

/// The items of a 3MF file's build list, each where the list places it; of other formats one object, the
/// file's mesh.
/// @throws as `readMesh`
std::vector<MeshObject> readMeshObjects(const std::string& path, const MeshUnits& units = {});

}  // namespace lamina
