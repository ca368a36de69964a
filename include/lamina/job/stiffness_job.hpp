// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/voxel/strand_thickness.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/stiffness/stiffness.hpp"

namespace lamina {

/// What of a part bears the load.
enum class PartSolid {
  AsDrawn,      ///< all that its surface encloses
  AsDeposited,  ///< what its toolpath leaves behind: it is sliced first
};

/// A part to be put under load.
struct StiffnessJob {
  std::string input;  ///< mesh file or name of a part; or .gcode, .mod, .csv, which are taken as deposited
  PartSolid solid = PartSolid::AsDrawn;  ///< of a mesh or named part
  std::string output;                    ///< elements with displacement and stress (.vtk); empty for none
  std::string deck;                      ///< the same problem for CalculiX (.inp); empty for none
  JobSettings settings;
};

/// What a load did to a part.
struct LoadedPart {
  StiffnessResult result;
  double solve_s = 0.0;  ///< time that the solution took
  StrandThickness thickness;
};

/// Fills voxels of deposition.voxel_mm, solves, writes. Everything is checked before a file is touched.
/// @throws InvalidInput, InvalidMesh, InvalidProgram, InvalidConfig, Unreachable, FileError, Cancelled
LoadedPart runStiffnessJob(const StiffnessJob& job, Progress& progress);

}  // namespace lamina
