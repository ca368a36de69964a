// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/layer_cells.hpp"

namespace lamina {

/// Two axes square to a normal, as rows.
Eigen::Matrix<double, 2, 3> planeSquareTo(const Eigen::Vector3d& normal);

/// What `LayerCells::beside` holds. Of cells that are equally near the one laid first.
/// @param normal  of the layers: cells are looked up in the plane square to it
std::vector<CellsBeside> cellsBeside(const LayerCells& cells, const Eigen::Vector3d& normal);

}  // namespace lamina
