// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pores/bit_stack.hpp"

#include <algorithm>
#include <array>

namespace lamina {
namespace {

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

}  // namespace

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

}  // namespace lamina
