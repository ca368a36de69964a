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

/// Each landmark is the vertex farthest from those before it; the first is the one farthest from vertex 0.
/// @param count  at least 1; all vertices if there are no more
/// @throws InvalidMesh if a vertex cannot be reached
Landmarks spreadLandmarks(const GeodesicDistances& geodesics, std::size_t vertices, std::size_t count);

/// Classical multidimensional scaling: the parameterization whose distances between landmarks come nearest to
/// the given ones, W = -1/2 J D² J, and each vertex where its distances to the landmarks put it
/// [DeSilva2004]. With all vertices as landmarks this is scaling without landmarks.
std::vector<Point2> landmarkMds(const Landmarks& landmarks);

}  // namespace lamina
