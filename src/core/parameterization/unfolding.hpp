// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/geometry/mesh/triangle_fans.hpp"

namespace lamina {

/// The plan of a surface that unrolls, by laying triangle on triangle from the middle outwards; where several
/// reach a vertex, it comes to lie between the places they give it. Nothing if the surface turns out not to
/// unroll, because two neighbours come to lie nearer or farther than they are by more than the tolerance. May
/// overlap itself, and may tear apart triangles that the way around a hole joins (`measureDistortion`
/// reports).
///
/// @param surface    connected by edges; its fans
/// @param tolerance  as a share of each length
/// @throws InvalidMesh if a vertex hangs together with the others by no triangle
std::optional<std::vector<Point2>> unfold(const Mesh& surface, const TriangleFans& fans, double tolerance);

}  // namespace lamina
