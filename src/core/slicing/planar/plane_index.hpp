// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Which triangles cross which horizontal planes, by ranks instead of heights: a vertex of rank r lies above
/// the planes 0 ... r - 1 and on or below the others, so that a triangle crosses the planes from its lowest
/// rank to below its highest.
struct PlaneIndex {
  std::vector<std::uint32_t> rank;       ///< one per vertex
  std::vector<std::size_t> begin;        ///< of plane i's triangles; one more than there are planes
  std::vector<std::uint32_t> triangles;  ///< ascending within each plane

  bool isAbove(std::uint32_t vertex, std::uint32_t plane) const { return rank[vertex] > plane; }
};

/// @param heights  z of the planes [mm], ascending
PlaneIndex indexPlanes(const Mesh& mesh, const std::vector<double>& heights);

}  // namespace lamina
