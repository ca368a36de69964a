// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/voxel_grid.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kMostAlongAxis = 1 << 30;
constexpr double kOnEdge = 1e-9;  // of a voxel: a box whose faces lie on voxel faces gains none by rounding

int bricksFor(int voxels, int brick) { return (voxels + brick - 1) / brick; }

/// Bits of the voxels of word `w` that lie in [low, high).
std::uint64_t bitsBetween(int w, int low, int high) {
  const int first = std::clamp(low - w * VoxelGrid::kWord, 0, VoxelGrid::kWord);
  const int last = std::clamp(high - w * VoxelGrid::kWord, 0, VoxelGrid::kWord);
  if (first >= last) return 0;
  const std::uint64_t up_to_last =
      last == VoxelGrid::kWord ? ~std::uint64_t{0} : (std::uint64_t{1} << last) - 1;
  return up_to_last & ~((std::uint64_t{1} << first) - 1);
}

/// 64 voxels of a row from voxel `i` on, which may lie beyond the frame.
std::uint64_t voxelsFrom(const VoxelGrid& grid, int i, int j, int k) {
  const VoxelFrame& frame = grid.frame();
  if (j < 0 || k < 0 || j >= frame.count[1] || k >= frame.count[2]) return 0;
  const auto wordAt = [&](int w) { return w < 0 || w >= grid.wordCount() ? 0 : grid.word(w, j, k); };
  const int w = i >= 0 ? i / VoxelGrid::kWord : -((-i + VoxelGrid::kWord - 1) / VoxelGrid::kWord);
  const int shift = i - w * VoxelGrid::kWord;
  if (shift == 0) return wordAt(w);
  return wordAt(w) >> shift | wordAt(w + 1) << (VoxelGrid::kWord - shift);
}

}  // namespace

VoxelFrame voxelFrame(const Box3& box, double voxel_mm) {
  if (box.isEmpty() || !box.low.allFinite() || !box.high.allFinite())
    throw InvalidInput("box of the voxels is empty or not finite");
  if (!(voxel_mm > 0.0 && std::isfinite(voxel_mm)))
    throw InvalidInput("voxel is " + numberText(voxel_mm) + " mm; must be above 0");
  const double longest = std::max(box.size().maxCoeff(), box.low.cwiseAbs().maxCoeff());
  if (longest / voxel_mm > kMostAlongAxis)
    throw InvalidInput("voxel is " + numberText(voxel_mm) + " mm; must be at least " +
                       numberText(longest / kMostAlongAxis) + " mm for a box of " + numberText(longest) +
                       " mm");
  VoxelFrame frame;
  frame.voxel_mm = voxel_mm;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double low = std::floor(box.low[axis] / voxel_mm + kOnEdge);
    const double high = std::ceil(box.high[axis] / voxel_mm - kOnEdge);
    frame.corner[axis] = low * voxel_mm;
    frame.count[static_cast<std::size_t>(axis)] = std::max(1, static_cast<int>(high - low));
  }
  return frame;
}

VoxelGrid::VoxelGrid(const VoxelFrame& frame)
    : frame_(frame),
      bricks_{bricksFor(frame.count[0], kWord), bricksFor(frame.count[1], kBrick),
              bricksFor(frame.count[2], kBrick)},
      table_(static_cast<std::size_t>(bricks_[0]) * static_cast<std::size_t>(bricks_[1]) *
                 static_cast<std::size_t>(bricks_[2]),
             kNone) {}

std::uint32_t VoxelGrid::addBrick() {
  store_.push_back(std::make_unique<Brick>());
  return static_cast<std::uint32_t>(store_.size() - 1);
}

void VoxelGrid::open(int i, int j, int k) {
  const std::uint32_t brick = table_[brickOf(i / kWord, j, k)];
  if (brick != kNone) (*store_[brick])[inBrick(j, k)] &= ~(std::uint64_t{1} << (i % kWord));
}

std::int64_t VoxelGrid::solidCount() const {
  std::int64_t count = 0;
  for (const auto& brick : store_)
    for (const std::uint64_t bits : *brick) count += __builtin_popcountll(bits);
  return count;
}

VoxelRange VoxelGrid::solidRange() const {
  VoxelRange range{frame_.count, {0, 0, 0}};
  for (int k = 0; k < frame_.count[2]; ++k)
    for (int j = 0; j < frame_.count[1]; ++j)
      for (int w = 0; w < wordCount(); ++w) {
        const std::uint64_t bits = word(w, j, k);
        if (bits == 0) continue;
        const std::array<int, 3> low{w * kWord + __builtin_ctzll(bits), j, k};
        const std::array<int, 3> high{(w + 1) * kWord - __builtin_clzll(bits), j + 1, k + 1};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          range.low[axis] = std::min(range.low[axis], low[axis]);
          range.high[axis] = std::max(range.high[axis], high[axis]);
        }
      }
  return range;
}

std::size_t VoxelGrid::bytes() const {
  return table_.size() * sizeof(table_[0]) + store_.size() * (sizeof(Brick) + sizeof(store_[0]));
}

VoxelGrid cropped(const VoxelGrid& grid, const VoxelRange& range) {
  if (range.isEmpty()) throw InvalidInput("range of voxels to crop is empty; must hold one at least");
  VoxelFrame frame = grid.frame();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    frame.corner[static_cast<Eigen::Index>(axis)] += range.low[axis] * frame.voxel_mm;
    frame.count[axis] = range.high[axis] - range.low[axis];
  }
  VoxelGrid made(frame);
  for (int k = 0; k < frame.count[2]; ++k)
    for (int j = 0; j < frame.count[1]; ++j)
      for (int w = 0; w < made.wordCount(); ++w)
        made.fillWord(
            w, j, k,
            bitsBetween(w, 0, frame.count[0]) &
                voxelsFrom(grid, range.low[0] + w * VoxelGrid::kWord, range.low[1] + j, range.low[2] + k));
  return made;
}

VoxelRange voxelsIn(const VoxelFrame& frame, const Box3& box) {
  VoxelRange range;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double low = std::ceil((box.low[a] - frame.corner[a]) / frame.voxel_mm - 0.5 - kOnEdge);
    const double high = std::floor((box.high[a] - frame.corner[a]) / frame.voxel_mm - 0.5 + kOnEdge) + 1.0;
    range.low[axis] = static_cast<int>(std::clamp(low, 0.0, double(frame.count[axis])));
    range.high[axis] = static_cast<int>(std::clamp(high, 0.0, double(frame.count[axis])));
  }
  return range;
}

}  // namespace lamina
