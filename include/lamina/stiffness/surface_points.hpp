// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/stiffness/stiffness.hpp"

namespace lamina {

/// Nodes on the surface of a part under load; every array has one entry per node.
struct SurfacePoints {
  std::vector<Eigen::Vector3f> place;         ///< position without load [mm]
  std::vector<Eigen::Vector3f> displacement;  ///< by the load [mm]
  std::vector<float> von_mises;               ///< mean von Mises stress of the adjacent elements [MPa]
};

/// The nodes on the surface, those with fewer than eight adjacent elements, in the order of the lattice.
SurfacePoints surfacePoints(const StiffnessResult& result);

}  // namespace lamina
