// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/conformal/facing_surface.hpp"

namespace lamina {

/// Those triangles among `candidates` that the shells of an open surface `source` do not reach: the point of
/// the surface nearest to a triangle's middle is on the border, and the triangle lies farther than
/// `within_mm` beyond the border, to the side.
TriangleNumbers unreached(const Mesh& mesh, const TriangleNumbers& candidates, const Mesh& source,
                          double within_mm);

/// Those points in front of an open surface `source` that its shells do not reach, even if the walls along
/// its border lean outwards by `steepest_deg`: the nearest point of the surface is on the border, and the
/// point lies farther beyond the border than `within_mm` and the lean of the walls.
std::vector<Point3> unreached(const std::vector<Point3>& points, const Mesh& source, double within_mm,
                              double steepest_deg);

}  // namespace lamina
