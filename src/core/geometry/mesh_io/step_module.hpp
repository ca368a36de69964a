// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh_io/mesh_objects.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"

namespace lamina {

/// Functions of the module `step`, which keeps Open CASCADE out of commands that read no STEP file, and out
/// of builds without it.
struct StepModule {
  /// Reads the solids of a STEP file [ISO10303-21], each at its position in the file [mm].
  std::vector<MeshObject> (*read_solids)(std::string_view bytes, const std::string& name,
                                         const Tessellation& tessellation, Progress& progress);
};

}  // namespace lamina
