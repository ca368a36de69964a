// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// The voxels of a grid as layers across an axis, each of rows of bits: what goes on from layer to layer
/// works on 64 voxels at a time whatever the axis.
class BitStack {
 public:
  /// All open.
  BitStack(int layers, int rows, int columns)
      : layers_(layers),
        rows_(rows),
        columns_(columns),
        words_((columns + VoxelGrid::kWord - 1) / VoxelGrid::kWord),
        bits_(static_cast<std::size_t>(layers) * static_cast<std::size_t>(rows) *
              static_cast<std::size_t>(words_)) {}

  int layers() const { return layers_; }
  int rows() const { return rows_; }
  int columns() const { return columns_; }
  int words() const { return words_; }

  /// The words of a row.
  std::uint64_t* row(int layer, int row) { return bits_.data() + start(layer, row); }
  const std::uint64_t* row(int layer, int row) const { return bits_.data() + start(layer, row); }

 private:
  std::size_t start(int layer, int row) const {
    return (static_cast<std::size_t>(layer) * static_cast<std::size_t>(rows_) +
            static_cast<std::size_t>(row)) *
           static_cast<std::size_t>(words_);
  }

  int layers_, rows_, columns_, words_;
  std::vector<std::uint64_t> bits_;
};

/// Layers across z have rows along x by y; across y, rows along x by z; across x, rows along y by z.
BitStack stackAcross(const VoxelGrid& grid, int axis);

}  // namespace lamina
