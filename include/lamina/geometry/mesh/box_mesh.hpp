// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A box as a closed mesh of twelve triangles that face outwards.
/// @param box  not empty
Mesh boxMesh(const Box3& box);

}  // namespace lamina
