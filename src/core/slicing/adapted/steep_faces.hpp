// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Refuses a part one of whose faces leans too far from the vertical. The flat bottom and the flat top of
/// the part are no walls and may lie as they do.
/// @throws Unsliceable with those faces, naming the greatest lean and where it is
void requireNoSteepFaces(const Mesh& mesh, double max_lean_deg);

}  // namespace lamina
