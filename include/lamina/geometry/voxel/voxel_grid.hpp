// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A box filled with cubes, in which the voxels of a grid lie. Voxel (i, j, k) counts along x, y and z from
/// the corner.
struct VoxelFrame {
  Point3 corner = Point3::Zero();  ///< low corner of voxel (0, 0, 0) [mm]
  double voxel_mm = 0.1;           ///< side of a voxel
  std::array<int, 3> count{};      ///< number of voxels along x, y, z

  std::int64_t voxelCount() const { return std::int64_t{count[0]} * count[1] * count[2]; }
  bool contains(int i, int j, int k) const {
    return i >= 0 && j >= 0 && k >= 0 && i < count[0] && j < count[1] && k < count[2];
  }
  /// Middle of a voxel [mm].
  Point3 centre(int i, int j, int k) const { return corner + voxel_mm * Point3(i + 0.5, j + 0.5, k + 0.5); }
  double voxelVolume() const { return voxel_mm * voxel_mm * voxel_mm; }
  /// The box that the voxels cover [mm].
  Box3 box() const { return {corner, corner + voxel_mm * Point3(count[0], count[1], count[2])}; }

  friend bool operator==(const VoxelFrame& a, const VoxelFrame& b) {
    return a.corner == b.corner && a.voxel_mm == b.voxel_mm && a.count == b.count;
  }
};

/// The smallest frame of voxels of this size that covers `box`. Its corner is at a whole multiple of the
/// voxel size from the origin, so that grids with the same voxel size match each other.
/// @throws InvalidInput if the box is empty or not finite, the voxel size is not positive, or more than 2^30
///   voxels would lie along an axis; then it names the smallest voxel size that fits
VoxelFrame voxelFrame(const Box3& box, double voxel_mm);

/// Voxel indices from `low` (included) to `high` (excluded).
struct VoxelRange {
  std::array<int, 3> low{};
  std::array<int, 3> high{};

  bool isEmpty() const { return low[0] >= high[0] || low[1] >= high[1] || low[2] >= high[2]; }
};

/// The voxels of a frame, each solid or open, one bit each. They are stored in bricks of 64 x 8 x 8 voxels; a
/// brick without solid voxels takes only four bytes. Outside the frame all voxels are open.
///
/// Voxels of a row (along x) are read and written 64 at a time as words: bit b of word w is voxel 64 w + b.
/// Bits outside the frame are 0.
class VoxelGrid {
 public:
  static constexpr int kWord = 64;  ///< voxels of a word, and of a brick along x
  static constexpr int kBrick = 8;  ///< voxels of a brick along y and z

  /// A grid with all voxels open.
  explicit VoxelGrid(const VoxelFrame& frame);

  const VoxelFrame& frame() const { return frame_; }

  bool isSolid(int i, int j, int k) const {
    return frame_.contains(i, j, k) && (word(i / kWord, j, k) >> (i % kWord) & 1U) != 0;
  }
  /// Makes a voxel solid.
  /// @param i, j, k  within the frame
  void fill(int i, int j, int k) { wordForWriting(i / kWord, j, k) |= std::uint64_t{1} << (i % kWord); }
  /// Makes a voxel open.
  /// @param i, j, k  within the frame
  void open(int i, int j, int k);

  /// Number of words along x; the last one may lie partly outside the frame.
  int wordCount() const { return bricks_[0]; }
  /// @param w, j, k  within the frame
  std::uint64_t word(int w, int j, int k) const {
    const std::uint32_t brick = table_[brickOf(w, j, k)];
    return brick == kNone ? 0 : (*store_[brick])[inBrick(j, k)];
  }
  /// Makes the voxels solid whose bits are set.
  /// @param w, j, k  within the frame; `bits` without any outside it
  void fillWord(int w, int j, int k, std::uint64_t bits) {
    if (bits != 0) wordForWriting(w, j, k) |= bits;
  }

  /// Number of solid voxels.
  std::int64_t solidCount() const;
  /// Volume of the solid voxels [mm³].
  double solidVolume() const { return static_cast<double>(solidCount()) * frame_.voxelVolume(); }
  /// The smallest range that contains all solid voxels; empty if there are none.
  VoxelRange solidRange() const;
  /// Memory of bricks and table [bytes].
  std::size_t bytes() const;

 private:
  using Brick = std::array<std::uint64_t, static_cast<std::size_t>(kBrick) * kBrick>;
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  std::size_t brickOf(int w, int j, int k) const {
    return (static_cast<std::size_t>(k / kBrick) * static_cast<std::size_t>(bricks_[1]) +
            static_cast<std::size_t>(j / kBrick)) *
               static_cast<std::size_t>(bricks_[0]) +
           static_cast<std::size_t>(w);
  }
  static std::size_t inBrick(int j, int k) {
    return static_cast<std::size_t>(k % kBrick) * kBrick + static_cast<std::size_t>(j % kBrick);
  }
  std::uint64_t& wordForWriting(int w, int j, int k) {
    std::uint32_t& brick = table_[brickOf(w, j, k)];
    if (brick == kNone) brick = addBrick();
    return (*store_[brick])[inBrick(j, k)];
  }
  std::uint32_t addBrick();

  VoxelFrame frame_;
  std::array<int, 3> bricks_{};       ///< along x, y, z
  std::vector<std::uint32_t> table_;  ///< which brick of the store lies here; kNone if none
  std::vector<std::unique_ptr<Brick>> store_;
};

/// A copy of the voxels in a range, as a grid with the range as its frame. The range may reach outside the
/// frame, where voxels are open.
/// @throws InvalidInput if the range is empty
VoxelGrid cropped(const VoxelGrid& grid, const VoxelRange& range);

/// The range of voxels whose centres lie in a box; may be empty.
VoxelRange voxelsIn(const VoxelFrame& frame, const Box3& box);

}  // namespace lamina
