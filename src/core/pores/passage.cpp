// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/pores/passage.hpp"

#include <algorithm>
#include <limits>

#include "lamina/base/parallel.hpp"
#include "pores/bit_stack.hpp"

namespace lamina {
namespace {

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
