// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/voxel/strand_thickness.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/stiffness/stiffness.hpp"

namespace lamina {

/// Which solid of a part bears the load.
enum class PartSolid {
  AsDrawn,      ///< all that its surface encloses
  AsDeposited,  ///< what its toolpath deposits; the part is sliced first
};

/// A part whose deformation under load is computed.
struct StiffnessJob {
  /// Mesh file or name of a parametric part; or a program or .csv, which always count as deposited.
  std::string input;
  PartSolid solid = PartSolid::AsDrawn;  ///< for a mesh or parametric part
  std::string output;                    ///< elements with displacement and stress (.vtk); empty for none
  std::string deck;                      ///< the same problem as input for CalculiX (.inp); empty for none
  JobSettings settings;
};

/// The deformation of a part under load.
struct LoadedPart {
  StiffnessResult result;
  double solve_s = 0.0;       ///< time that the solution took
  StrandThickness thickness;  ///< number of voxels across the solid
};

/// Fills voxels of size deposition.voxel_mm, computes the deformation, and writes the outputs. Everything is
/// checked before a file is touched.
/// @throws InvalidInput, InvalidMesh, InvalidProgram, InvalidConfig, Unreachable, FileError, Cancelled
LoadedPart runStiffnessJob(const StiffnessJob& job, Progress& progress);

}  // namespace lamina
