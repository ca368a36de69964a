// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/stiffness/stiffness.hpp"

namespace lamina {

/// Nodes on the surface of a part under load, one entry each in every array.
struct SurfacePoints {
  std::vector<Eigen::Vector3f> place;         ///< before the load [mm]
  std::vector<Eigen::Vector3f> displacement;  ///< [mm]
  std::vector<float> von_mises;               ///< mean of the elements around the node [MPa]
};

/// The nodes that have fewer than eight elements around them, in the order of the lattice.
SurfacePoints surfacePoints(const StiffnessResult& result);

}  // namespace lamina
