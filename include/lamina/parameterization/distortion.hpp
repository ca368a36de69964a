// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Differences between lengths on a surface and in its parameterization.
struct Distortion {
  /// Sum over the triangles of |1 - perimeter in the parameter plane / on the surface|.
  double index_sum = 0.0;
  double index_mean = 0.0;  ///< that sum over the number of triangles
  /// Least ratio of a length on the surface to that in the parameter plane, over all triangles and
  /// directions.
  double least_stretch = 1.0;
  /// Greatest of these ratios; infinite if a triangle has no area in the parameter plane.
  double greatest_stretch = 1.0;
  std::uint32_t least_triangle = 0;     ///< triangle with the least ratio
  std::uint32_t greatest_triangle = 0;  ///< triangle with the greatest ratio
  std::size_t flipped = 0;  ///< number of triangles that do not wind counter-clockwise in the parameter plane
};

/// Measures the distortion, in linear time. Triangles that are nearly lines on the surface stretch as their
/// two longer sides do. These are triangles at most 0.02 mm high, or at most as high as a millionth of their
/// longest side. Triangles at most 0.005 mm high do not count as flipped. If triangles are small, both
/// heights are less: a twentieth of the square root of their mean area.
/// @param parameterization  of each vertex [mm]
/// @throws InvalidInput if there are not as many places as vertices
Distortion measureDistortion(const Mesh& surface, const std::vector<Point2>& parameterization);

/// Whether no two triangles overlap in the parameter plane. Only borders are tested: if no triangle is
/// flipped, one border encloses the others, and no border crosses itself or another one, then no triangles
/// overlap. Borders may touch, and may cross by the height up to which triangles do not count as flipped. n
/// log n time.
/// @param surface  connected by edges
/// @param parameterization  as above, without flipped triangles
bool isInjective(const Mesh& surface, const std::vector<Point2>& parameterization);

}  // namespace lamina
