// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/layer_cells.hpp"

namespace lamina {

/// Two unit vectors square to a normal and to each other, as rows.
Eigen::Matrix<double, 2, 3> planeSquareTo(const Eigen::Vector3d& normal);

/// The values of `LayerCells::beside`. Of equally near cells the one laid first is taken.
/// @param normal  of the layers: distances are those in the plane square to it
std::vector<CellsBeside> cellsBeside(const LayerCells& cells, const Eigen::Vector3d& normal);

}  // namespace lamina
