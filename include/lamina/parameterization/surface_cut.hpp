// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// The part of a surface where a field, linear in each triangle, is not negative. Triangles that the zero
/// line of the field crosses are cut along it; quantities at new vertices are interpolated, and normals made
/// of unit length. Unused vertices are removed. Triangles keep their order.
/// @param field  one finite value per vertex
/// @throws InvalidInput if there are not as many values as vertices, or one is not finite
LayerSurface whereNotNegative(const LayerSurface& surface, const std::vector<double>& field);

/// The components connected by edges, in the order of their first triangles. A vertex at which two
/// pieces touch is in both.
std::vector<LayerSurface> connectedPieces(const LayerSurface& surface);

/// The given triangles of a surface as a surface of their own, without the vertices that they do not use.
/// @param triangles  their indices
LayerSurface pieceOf(const LayerSurface& surface, const std::vector<std::uint32_t>& triangles);

}  // namespace lamina
