// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "lamina/stiffness/elastic_material.hpp"

namespace lamina {

using ElementMatrix = Eigen::Matrix<double, 24, 24>;

/// Stiffness [N/mm] of a cube with a node at each corner and displacements linear along each axis, integrated
/// exactly. Node c lies at the high end along x, y, z where bit 0, 1, 2 of c is set; row and column 3 c + a
/// is component a of node c.
ElementMatrix elementStiffness(const ElasticMaterial& material, double element_mm);

}  // namespace lamina
