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

/// What the module `step` offers: Open CASCADE stays out of commands that read no STEP, and of builds without
/// it.
struct StepModule {
  /// The solids of a STEP file [ISO10303-21], each where the file places it [mm].
  std::vector<MeshObject> (*read_solids)(std::string_view bytes, const std::string& name,
                                         const Tessellation& tessellation, Progress& progress);
};

}  // namespace lamina
