// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

/// Pairs the half-edges of one edge by the angle of their triangles around it, each pair one of either
/// direction and the two sides of one wedge of material; wedges nest but never cross. Where triangles lie on
/// each other, the bodies on their two sides stay apart. Triangles without area have no angle and are paired
/// in any of these ways. What has no partner is left out.
///
/// @param half_edges  all of one edge between two different vertices
std::vector<std::pair<HalfEdge, HalfEdge>> pairWedges(const Mesh& mesh,
                                                      const std::vector<HalfEdge>& half_edges);

}  // namespace lamina
