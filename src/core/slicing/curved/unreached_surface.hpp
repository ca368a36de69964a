// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/conformal/facing_surface.hpp"

namespace lamina {

/// The triangles, among `candidates`, that shells of an open surface do not come to: whose middle is nearest
/// to the surface's border, and farther than `within_mm` to the side of where that border goes.
TriangleNumbers unreached(const Mesh& mesh, const TriangleNumbers& candidates, const Mesh& source,
                          double within_mm);

/// The points, in front of where a surface faces, that its shells do not come to even if walls beside its
/// border lean outwards by `steepest_deg`: nearest to the border, and farther to the side of it than
/// `within_mm` and that.
std::vector<Point3> unreached(const std::vector<Point3>& points, const Mesh& source, double within_mm,
                              double steepest_deg);

}  // namespace lamina
