// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/mesh.hpp"
#include "lamina/slicing/facing_surface.hpp"

namespace lamina {

/// The triangles, among `candidates`, that shells of an open surface do not come to: whose middle is nearest
/// to the surface's border, and farther than `within_mm` to the side of where that border goes.
TriangleNumbers unreached(const Mesh& mesh, const TriangleNumbers& candidates, const Mesh& source,
                          double within_mm);

}  // namespace lamina
