// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A field whose zero line cuts a connected piece in two, one value per vertex [mm].
///
/// A piece around which one can run, between two long borders, is cut into the places nearer to a way that
/// joins them and those nearer to a way on the other side. Any other one is cut midway between two vertices
/// far from each other. If the surface has a peak or a saddle point that lies flat in no parameterization,
/// the line is shifted to run through it. The line keeps clear of vertices that it nearly meets by running
/// through them.
std::vector<double> cuttingField(const Mesh& piece);

}  // namespace lamina
