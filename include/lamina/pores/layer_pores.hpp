// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// Heights that a layer takes up [mm, frame of the grid].
struct LayerBand {
  double low_mm = 0.0;
  double high_mm = 0.0;
};

/// Numbers of voxels of a layer: in the slices of the grid whose middles lie in the layer's band.
struct LayerPores {
  LayerBand band;
  std::int64_t solid = 0;
  std::int64_t open = 0;  ///< all other voxels of the frame in these slices
  /// Open voxels that are cut off from the border of the frame within their slice.
  std::int64_t enclosed = 0;

  /// Share of the enclosed voxels in the enclosed and solid ones; 0 if there are none.
  double voidRatio() const;
  /// Share of the open voxels in all voxels; 0 if there are none.
  double openRatio() const;
};

/// Counts the voxels of layers, in parallel, with memory proportional to a slice for each thread.
/// @param solid  with a margin of one voxel around the print: pores that touch the border are not enclosed
/// @throws InvalidInput if a band is not finite or upside down
/// @throws Cancelled if `progress` is cancelled
std::vector<LayerPores> poresByLayer(const VoxelGrid& solid, const std::vector<LayerBand>& bands,
                                     Progress& progress);

/// The open voxels of one slice, in a frame of one voxel along z.
VoxelGrid openSlice(const VoxelGrid& solid, int k);

}  // namespace lamina
