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
  std::int64_t voxels = 0;   ///< solid ones
  double porosity = 0.0;     ///< part of the box around all that is solid that is open, 0 to 1; 0 of nothing
  double surface_mm2 = 0.0;  ///< of voxel faces
  double highest_mm = 0.0;   ///< `VoxelDeposit::highest`
};

/// A deposit and its figures.
struct DepositedPart {
  VoxelGrid grid;
  DepositSummary summary;
};

/// Cost is proportional to the words of the grid.
DepositSummary summaryOf(const VoxelGrid& grid, const DepositTotals& totals, double highest_mm);

/// Lays the toolpath, reports its figures and writes its surface.
/// @throws InvalidInput as `depositedVoxels`; if the output is no .stl, or the source
/// @throws Cancelled, FileError; then nothing is written
DepositedPart runDepositJob(const DepositJob& job, Progress& progress);

}  // namespace lamina
