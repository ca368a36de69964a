// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina {

/// A part fit to be sliced, and what was changed to make it so.
struct SourcePart {
  Mesh mesh;
  MeshTopology topology;  ///< of the mesh; without border
  std::vector<std::string> repairs;
  Mesh base;  ///< what it is laid on, in its frame; empty for the bed
};

/// @param part  name of a parametric part, otherwise path of a mesh file
/// @throws InvalidMesh if the mesh cannot be read or repaired, or is not sound and the policy is strict;
/// FileError
SourcePart readPart(const std::string& part, const InputSettings& settings);

}  // namespace lamina
