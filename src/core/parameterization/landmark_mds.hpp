// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "lamina/parameterization/geodesic.hpp"

namespace lamina {

/// Vertices spread over a mesh, and the distances of all vertices from them.
struct Landmarks {
  std::vector<std::uint32_t> vertices;
  std::vector<std::vector<double>> distance;  ///< [landmark][vertex] [mm]
};

/// Chooses landmarks: each is the vertex farthest from those before; the first one is farthest from vertex 0.
/// @param count  at least 1; all vertices are landmarks if there are not more
/// @throws InvalidMesh if a vertex cannot be reached
Landmarks spreadLandmarks(const GeodesicDistances& geodesics, std::size_t vertices, std::size_t count);

/// Classical multidimensional scaling: the parameterization whose distances between landmarks are closest to
/// the given ones, W = -1/2 J D² J; other vertices are placed by their distances to the landmarks
/// [DeSilva2004]. If all vertices are landmarks this is ordinary classical scaling.
std::vector<Point2> landmarkMds(const Landmarks& landmarks);

}  // namespace lamina
