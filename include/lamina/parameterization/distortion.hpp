// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// How the lengths of a surface differ from those of its parameterization.
struct Distortion {
  double index_sum = 0.0;   ///< over the triangles of |1 - perimeter in the parameter plane / on the surface|
  double index_mean = 0.0;  ///< per triangle
  /// Length on the surface / in the parameter plane, over all triangles and directions.
  double least_stretch = 1.0;
  /// The same; infinite where the parameterization of a triangle has no area.
  double greatest_stretch = 1.0;
  std::uint32_t least_triangle = 0;
  std::uint32_t greatest_triangle = 0;
  std::size_t flipped = 0;  ///< triangles that do not wind counter-clockwise in the parameter plane
};

/// Triangles that are nearly lines on the surface count as lines, which stretch as their two longer sides do:
/// those less than 0.02 mm high (less where triangles are small: a twentieth of a usual one), or a millionth
/// of their longest side. Those less than 0.005 mm high cannot be flipped. Linear time.
/// @param parameterization  of each vertex [mm]
/// @throws InvalidInput if there are not as many places as vertices
Distortion measureDistortion(const Mesh& surface, const std::vector<Point2>& parameterization);

/// Whether no two triangles overlap in the parameter plane. Tested at the borders: where no triangle is
/// flipped, one border encloses the others and no border meets itself or another one, none can. Borders may
/// touch, and cross by the height of a triangle that cannot be flipped. n log n time.
/// @param surface           connected by edges
/// @param parameterization  as above, without flipped triangles
bool isInjective(const Mesh& surface, const std::vector<Point2>& parameterization);

}  // namespace lamina
