// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina {

/// The mesh of a part, repaired, or refused if it needs repair, as the settings ask. Slicing itself does not
/// use this function, as it needs more than the mesh.
/// @param part  name of a parametric part, otherwise path of a mesh file
/// @throws InvalidMesh if the mesh cannot be read or repaired, or is not sound and the policy is strict
/// @throws FileError
Mesh partMesh(const std::string& part, const InputSettings& settings);

}  // namespace lamina
