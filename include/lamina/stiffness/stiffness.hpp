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

/// A connected piece of solid that was left out, since it does not reach all boundary conditions and so bears
/// no load.
struct DroppedPart {
  std::int64_t elements = 0;  ///< number of its elements
  Box3 box;                   ///< bounding box [mm]
  std::string misses;         ///< names of the boundary conditions that it does not reach: "base, top"
};

/// Finite elements of a part, one for each voxel that bears load.
struct ElementModel {
  ElementLattice lattice;
  Point3 corner = Point3::Zero();  ///< low corner of the lattice [mm]
  double element_mm = 0.0;         ///< side of an element
  LoadCase load;
};

/// Response of a part to a load.
struct StiffnessResult {
  ElementModel model;
  GivenNodes given;                  ///< nodes whose displacement is given
  NodeField<double> displacement;    ///< of each node [mm]
  std::vector<Stress> stress;        ///< in the middle of each element, in the order of the lattice's runs
  double force_n = 0.0;              ///< on the plate or punch, from the reactions of the nodes at rest
  double modulus_mpa = 0.0;          ///< equivalent modulus
  double imbalance_n = 0.0;          ///< sum of the reactions of nodes at rest and displaced nodes; ideally 0
  float greatest_stress_mpa = 0.0F;  ///< greatest von Mises stress
  Point3 greatest_stress_at = Point3::Zero();  ///< middle of the element with that stress [mm]
  int iterations = 0;                          ///< number of iterations of the solver
  double residual = 0.0;                       ///< residual that was reached
  std::vector<DroppedPart> dropped;            ///< pieces of solid that were left out
};

/// Computes the linear-elastic displacements and stresses of the solid voxels of a grid under a load, and the
/// equivalent modulus [Vega2023, section 7.2.2.7]: one element with eight nodes per voxel, small
/// displacements, perfect bonds. Pieces of solid, connected face by face, that do not reach all boundary
/// conditions are left out and reported. The result is the same for any number of threads.
///
/// @throws InvalidInput   if no solid bears the load, the memory does not suffice (names the voxel size that
///                        would fit), or the residual is not reached within the allowed iterations
/// @throws InvalidConfig  if a setting is out of range or the span does not fit on the part
/// @throws Cancelled
StiffnessResult solveStiffness(const VoxelGrid& grid, const StiffnessSettings& settings, Progress& progress);

}  // namespace lamina
