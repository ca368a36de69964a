// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "lamina/stiffness/elastic_material.hpp"

namespace lamina {

using ElementMatrix = Eigen::Matrix<double, 24, 24>;

/// Stiffness matrix [N/mm] of a trilinear hexahedral element (8 nodes) that is a cube, integrated exactly.
/// Node c lies at the upper end of the cube along x if bit 0 of c is set, along y if bit 1 is, along z if bit
/// 2 is. Row and column 3 c + a belong to the displacement of node c along axis a.
ElementMatrix elementStiffness(const ElasticMaterial& material, double element_mm);

}  // namespace lamina
