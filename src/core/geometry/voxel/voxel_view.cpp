// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/voxel_view.hpp"

#include <cstdint>

#include "lamina/geometry/voxel/isosurface.hpp"

namespace lamina {
namespace {

constexpr int kLastBit = VoxelGrid::kWord - 1;

std::uint64_t wordAt(const VoxelGrid& grid, int w, int j, int k) {
  const auto& count = grid.frame().count;
  const bool is_inside = w >= 0 && j >= 0 && k >= 0 && w < grid.wordCount() && j < count[1] && k < count[2];
  return is_inside ? grid.word(w, j, k) : 0;
}

/// Those of the voxels of a word that are solid on all sides.
std::uint64_t enclosedIn(const VoxelGrid& grid, int w, int j, int k) {
  const std::uint64_t bits = grid.word(w, j, k);
  const std::uint64_t before = bits << 1U | wordAt(grid, w - 1, j, k) >> kLastBit;
  const std::uint64_t after = bits >> 1U | wordAt(grid, w + 1, j, k) << kLastBit;
  return bits & before & after & wordAt(grid, w, j - 1, k) & wordAt(grid, w, j + 1, k) &
         wordAt(grid, w, j, k - 1) & wordAt(grid, w, j, k + 1);
}

/// Calls `visit(i, j)` for each voxel of a slice whose bit is set in `bitsOf(w, j)`.
template <class BitsOf, class Visit>
void forEachBitOfSlice(const VoxelGrid& grid, int k, const BitsOf& bitsOf, const Visit& visit) {
  for (int j = 0; j < grid.frame().count[1]; ++j)
    for (int w = 0; w < grid.wordCount(); ++w) {
      if (grid.word(w, j, k) == 0) continue;
      for (std::uint64_t bits = bitsOf(w, j); bits != 0; bits &= bits - 1)
        visit(w * VoxelGrid::kWord + __builtin_ctzll(bits), j);
    }
}

VoxelFrame coarseFrame(VoxelFrame frame, int factor) {
  frame.voxel_mm *= factor;
  for (int& count : frame.count) count = (count + factor - 1) / factor;
  return frame;
}

/// The finest view of the grid that has no more than `most` of what `sizeOf` counts.
template <class View, class ViewOf, class SizeOf>
View limited(const VoxelGrid& grid, std::size_t most, const ViewOf& viewOf, const SizeOf& sizeOf) {
  View view = viewOf(grid);
  for (int factor = 2; sizeOf(view) > most; ++factor) view = viewOf(coarsened(grid, factor));
  return view;
}

}  // namespace

std::vector<Point3> surfaceVoxels(const VoxelGrid& grid) {
  std::vector<Point3> points;
  for (int k = 0; k < grid.frame().count[2]; ++k)
    forEachBitOfSlice(
        grid, k, [&](int w, int j) { return grid.word(w, j, k) & ~enclosedIn(grid, w, j, k); },
        [&](int i, int j) { points.push_back(grid.frame().centre(i, j, k)); });
  return points;
}

VoxelGrid coarsened(const VoxelGrid& grid, int factor) {
  VoxelGrid made(coarseFrame(grid.frame(), factor));
  const auto& count = made.frame().count;
  const std::int64_t half = (std::int64_t{factor} * factor * factor + 1) / 2;
  const auto across = static_cast<std::size_t>(count[0]);
  std::vector<std::int64_t> solid(across * static_cast<std::size_t>(count[1]), 0);
  const auto fillCubes = [&](int k) {
    for (std::size_t cube = 0; cube < solid.size(); ++cube)
      if (solid[cube] >= half)
        made.fill(static_cast<int>(cube % across), static_cast<int>(cube / across), k / factor);
    solid.assign(solid.size(), 0);
  };
  for (int k = 0; k < grid.frame().count[2]; ++k) {
    forEachBitOfSlice(
        grid, k, [&](int w, int j) { return grid.word(w, j, k); },
        [&](int i, int j) {
          ++solid[static_cast<std::size_t>(j / factor) * across + static_cast<std::size_t>(i / factor)];
        });
    if ((k + 1) % factor == 0 || k + 1 == grid.frame().count[2]) fillCubes(k);
  }
  return made;
}

std::vector<Point3> shownVoxels(const VoxelGrid& grid, std::size_t most) {
  return limited<std::vector<Point3>>(grid, most, surfaceVoxels,
                                      [](const auto& view) { return view.size(); });
}

Mesh shownSurface(const VoxelGrid& grid, std::size_t most) {
  return limited<Mesh>(
      grid, most, [](const VoxelGrid& shown) { return isosurface(shown); },
      [](const Mesh& view) { return view.triangles.size(); });
}

}  // namespace lamina
