// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/pores/layer_pores.hpp"

namespace lamina::cli {

/// Input of a subcommand: voxels, and the layers in which they were deposited.
struct VoxelInput {
  VoxelGrid grid;
  std::vector<LayerBand> layers;
};

/// Reads a program or toolpath and lays it into voxels of `deposition.voxel_mm`, in coordinates of the bed; a
/// part (mesh file or name) fills the voxels that it encloses, and has no layers.
VoxelInput readVoxels(const std::string& input, const JobSettings& settings, Progress& progress);

/// The box between two corners; nothing without numbers.
/// @param corners_mm  six numbers or none
/// @throws InvalidInput if the second corner is not above the first along all axes
std::optional<Box3> cropFrom(const std::vector<double>& corners_mm);

}  // namespace lamina::cli
