// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A field, one value for each vertex [mm], along whose zero line a connected piece is cut in two.
///
/// A ring-shaped piece, with two long borders, is cut into the area nearer to a line that joins the borders
/// on one side, and the area nearer to such a line on the other side. Any other piece is cut midway between
/// two vertices that are far from each other. If the surface has a peak or a saddle point that cannot be laid
/// flat, the line is shifted to pass through it. Where the line nearly meets a vertex it is led through the
/// vertex.
std::vector<double> cuttingField(const Mesh& piece);

}  // namespace lamina
