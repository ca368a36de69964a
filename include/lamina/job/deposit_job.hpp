// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/deposition/toolpath_deposit.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A toolpath to be deposited into voxels.
struct DepositJob {
  Toolpath toolpath;   ///< in coordinates of the bed
  std::string output;  ///< surface to write (.stl); empty for none
  std::string source;  ///< file that the toolpath was read from, which no output overwrites; may be empty
  DepositionSettings settings;
};

/// Figures of a deposit.
struct DepositSummary {
  DepositTotals totals;
  double voxel_mm = 0.0;
  std::int64_t voxels = 0;  ///< number of solid voxels
  /// Share of open voxels in the bounding box of the solid voxels, 0 to 1; 0 if none is solid.
  double porosity = 0.0;
  double surface_mm2 = 0.0;  ///< total area of the faces between solid and open voxels
  double highest_mm = 0.0;   ///< highest place of the deposit, as `VoxelDeposit::highest`
};

/// A deposit as voxels, and its figures.
struct DepositedPart {
  VoxelGrid grid;
  DepositSummary summary;
};

/// The figures of a deposit. The cost is proportional to the number of words in the grid.
DepositSummary summaryOf(const VoxelGrid& grid, const DepositTotals& totals, double highest_mm);

/// Deposits the toolpath into voxels, computes the figures, and writes the surface.
/// @throws InvalidInput as `depositedVoxels`; if the output is not an .stl file, or is the source
/// @throws Cancelled, FileError; then nothing is written
DepositedPart runDepositJob(const DepositJob& job, Progress& progress);

}  // namespace lamina
