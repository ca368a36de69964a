// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/pores/passage.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {
namespace {

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

constexpr int kWord = VoxelGrid::kWord;
using Block = std::array<std::uint64_t, kWord>;

/// Bit b of word w becomes bit w of word b: halves are exchanged across the diagonal, then quarters, and so
/// on.
void transpose(Block& block) {
  std::uint64_t mask = 0x00000000FFFFFFFF;
  for (unsigned half = 32; half != 0; half >>= 1U, mask ^= mask << half)
    for (unsigned first = 0; first < kWord; first = ((first | half) + 1) & ~half) {
      const std::uint64_t exchanged = (block[first] >> half ^ block[first | half]) & mask;
      block[first] ^= exchanged << half;
      block[first | half] ^= exchanged;
    }
}

BitStack stackAcrossX(const VoxelGrid& grid) {
  const auto& count = grid.frame().count;
  BitStack stack(count[0], count[2], count[1]);
  Block block;
  for (int k = 0; k < count[2]; ++k)
    for (int v = 0; v < stack.words(); ++v)
      for (int w = 0; w < grid.wordCount(); ++w) {
        block.fill(0);
        const int rows = std::min(kWord, count[1] - v * kWord);
        for (int j = 0; j < rows; ++j) block[static_cast<std::size_t>(j)] = grid.word(w, v * kWord + j, k);
        transpose(block);
        const int layers = std::min(kWord, count[0] - w * kWord);
        for (int i = 0; i < layers; ++i) stack.row(w * kWord + i, k)[v] = block[static_cast<std::size_t>(i)];
      }
  return stack;
}

/// Layers across z have rows along x by y; across y, rows along x by z; across x, rows along y by z.
BitStack stackAcross(const VoxelGrid& grid, int axis) {
  if (axis == 0) return stackAcrossX(grid);
  const auto& count = grid.frame().count;
  const bool is_z = axis == 2;
  BitStack stack(is_z ? count[2] : count[1], is_z ? count[1] : count[2], count[0]);
  for (int layer = 0; layer < stack.layers(); ++layer)
    for (int row = 0; row < stack.rows(); ++row)
      for (int w = 0; w < stack.words(); ++w)
        stack.row(layer, row)[w] = is_z ? grid.word(w, row, layer) : grid.word(w, layer, row);
  return stack;
}

/// Bits of a row and those beside them.
std::uint64_t widened(const std::uint64_t* row, int w, int words) {
  const std::uint64_t before = w > 0 ? row[w - 1] >> (VoxelGrid::kWord - 1) : 0;
  const std::uint64_t after = w + 1 < words ? row[w + 1] << (VoxelGrid::kWord - 1) : 0;
  return row[w] | row[w] << 1U | row[w] >> 1U | before | after;
}

/// What is reached in a layer: pores next to those reached in the layer before.
void reachLayer(const BitStack& pores, BitStack& reached, int layer, int before) {
  const int words = pores.words();
  for (int row = 0; row < pores.rows(); ++row)
    for (int w = 0; w < words; ++w) {
      std::uint64_t near = 0;
      for (int beside = std::max(0, row - 1); beside <= std::min(pores.rows() - 1, row + 1); ++beside)
        near |= widened(reached.row(before, beside), w, words);
      reached.row(layer, row)[w] = near & pores.row(layer, row)[w];
    }
}

BitStack reachedFrom(const BitStack& pores, int first, int step) {
  BitStack reached(pores.layers(), pores.rows(), pores.columns());
  for (int row = 0; row < pores.rows(); ++row)
    std::copy(pores.row(first, row), pores.row(first, row) + pores.words(), reached.row(first, row));
  for (int layer = first + step; layer >= 0 && layer < pores.layers(); layer += step)
    reachLayer(pores, reached, layer, layer - step);
  return reached;
}

/// Voxels of a layer that are in both.
std::int64_t countBoth(const BitStack& a, const BitStack& b, int layer) {
  std::int64_t count = 0;
  for (int row = 0; row < a.rows(); ++row)
    for (int w = 0; w < a.words(); ++w)
      count += __builtin_popcountll(a.row(layer, row)[w] & b.row(layer, row)[w]);
  return count;
}

}  // namespace

Passage passageAlong(const VoxelGrid& pores, int axis) {
  const BitStack stack = stackAcross(pores, axis);
  const int last = stack.layers() - 1;
  const BitStack forward = reachedFrom(stack, 0, 1);
  const BitStack backward = reachedFrom(stack, last, -1);
  std::int64_t narrowest = std::numeric_limits<std::int64_t>::max();
  for (int layer = 0; layer <= last; ++layer)
    narrowest = std::min(narrowest, countBoth(forward, backward, layer));
  const double to_percent = 100.0 / (static_cast<double>(stack.rows()) * stack.columns());
  return {static_cast<double>(countBoth(forward, forward, last)) * to_percent,
          static_cast<double>(countBoth(backward, backward, 0)) * to_percent,
          static_cast<double>(narrowest) * to_percent};
}

Passages passages(const VoxelGrid& pores) {
  Passages found;
  NoProgress nobody;
  parallelFor(
      3, [&](std::size_t axis) { found.along[axis] = passageAlong(pores, static_cast<int>(axis)); }, nobody,
      "passages");
  return found;
}

double Passages::epciPercent() const {
  double sum = 0.0;
  for (const Passage& passage : along) sum += passage.epci_forward_percent + passage.epci_backward_percent;
  return sum / 6.0;
}

double Passages::mecsiPercent() const {
  return (along[0].mecsi_percent + along[1].mecsi_percent + along[2].mecsi_percent) / 3.0;
}

}  // namespace lamina
