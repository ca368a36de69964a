// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"
#include "lamina/stiffness/element_lattice.hpp"
#include "lamina/stiffness/load_case.hpp"
#include "lamina/stiffness/node_field.hpp"
#include "lamina/stiffness/stiffness_settings.hpp"
#include "lamina/stiffness/stress.hpp"

namespace lamina {

/// Solid that bears nothing and was left out: it does not reach all that holds and presses.
struct DroppedPart {
  std::int64_t elements = 0;
  Box3 box;            ///< [mm]
  std::string misses;  ///< what it does not reach: "top", "base, top"
};

/// A part as elements, one for each voxel that bears load.
struct ElementModel {
  ElementLattice lattice;
  Point3 corner = Point3::Zero();  ///< of the lattice [mm]
  double element_mm = 0.0;
  LoadCase load;
};

/// What a load does to a part.
struct StiffnessResult {
  ElementModel model;
  GivenNodes given;                  ///< nodes whose displacement is given, along x, y, z
  NodeField<double> displacement;    ///< of each node [mm]
  std::vector<Stress> stress;        ///< in the middle of each element, in the order of the lattice's runs
  double force_n = 0.0;              ///< of the plate or punch, from the reactions of what rests
  double modulus_mpa = 0.0;          ///< equivalent modulus
  double imbalance_n = 0.0;          ///< reactions of what rests and of what is moved, added
  float greatest_stress_mpa = 0.0F;  ///< von Mises
  Point3 greatest_stress_at = Point3::Zero();  ///< [mm]
  int iterations = 0;
  double residual = 0.0;  ///< reached
  std::vector<DroppedPart> dropped;
};

/// Linear-elastic displacements and stresses of the solid voxels of a grid under a load, and the modulus that
/// follows [Vega2023, section 7.2.2.7]: one element with eight nodes a voxel, small displacements, perfectly
/// bonded. Solid that does not hang together, face by face, with all that holds and presses is left out and
/// reported. The result is the same whatever the number of threads.
///
/// @throws InvalidInput   if nothing bears the load, or the memory does not suffice (names the voxel that
///                        would fit), or forces are not balanced after as many iterations as are allowed
/// @throws InvalidConfig  if a setting is out of range or the span does not lie on the part
/// @throws Cancelled
StiffnessResult solveStiffness(const VoxelGrid& grid, const StiffnessSettings& settings, Progress& progress);

}  // namespace lamina
