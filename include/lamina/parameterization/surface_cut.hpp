// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// The part of a surface where a field, linear in each triangle, is not negative. Triangles that its zero
/// line crosses are cut along it; new vertices get interpolated quantities, normals of unit length. Unused
/// vertices are removed. Triangles keep their order.
/// @param field  one finite value per vertex
/// @throws InvalidInput if there are not as many values as vertices, or one is not finite
LayerSurface whereNotNegative(const LayerSurface& surface, const std::vector<double>& field);

/// The components connected by edges, in the order of their first triangles. A vertex at which two
/// pieces touch is in both.
std::vector<LayerSurface> connectedPieces(const LayerSurface& surface);

/// Triangles of a surface by number, as a surface of their own, without the vertices they do not use.
LayerSurface pieceOf(const LayerSurface& surface, const std::vector<std::uint32_t>& triangles);

}  // namespace lamina
