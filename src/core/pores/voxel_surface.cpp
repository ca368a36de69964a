// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/pores/voxel_surface.hpp"

#include <cstdint>
#include <numeric>
#include <vector>

#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

std::int64_t differing(std::uint64_t a, std::uint64_t b) { return __builtin_popcountll(a ^ b); }

/// Faces of a row across x.
std::int64_t facesAlongRow(const VoxelGrid& solid, int j, int k) {
  std::int64_t faces = 0;
  std::uint64_t before = 0;
  for (int w = 0; w < solid.wordCount(); ++w) {
    const std::uint64_t bits = solid.word(w, j, k);
    faces += differing(bits, bits << 1U | before);
    before = bits >> (VoxelGrid::kWord - 1);
  }
  // A row of whole words may end solid; in any other the bit after the last one is within the word.
  return faces + static_cast<std::int64_t>(before);
}

/// Faces of a slice across x and y, and those to the slice below it.
std::int64_t facesOfSlice(const VoxelGrid& solid, int k) {
  const auto& count = solid.frame().count;
  std::int64_t faces = 0;
  for (int j = 0; j < count[1]; ++j) {
    faces += facesAlongRow(solid, j, k);
    for (int w = 0; w < solid.wordCount(); ++w) {
      const std::uint64_t bits = solid.word(w, j, k);
      faces += differing(bits, j > 0 ? solid.word(w, j - 1, k) : 0);
      faces += differing(bits, k > 0 ? solid.word(w, j, k - 1) : 0);
      if (j + 1 == count[1]) faces += differing(bits, 0);
      if (k + 1 == count[2]) faces += differing(bits, 0);
    }
  }
  return faces;
}

}  // namespace

double voxelFaceArea(const VoxelGrid& solid) {
  const VoxelFrame& frame = solid.frame();
  std::vector<std::int64_t> faces(static_cast<std::size_t>(frame.count[2]));
  NoProgress nobody;
  parallelFor(
      faces.size(), [&](std::size_t k) { faces[k] = facesOfSlice(solid, static_cast<int>(k)); }, nobody,
      "surface");
  const std::int64_t total = std::accumulate(faces.begin(), faces.end(), std::int64_t{0});
  return static_cast<double>(total) * frame.voxel_mm * frame.voxel_mm;
}

}  // namespace lamina
