// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/solid_union.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "lamina/geometry/voxel/isosurface.hpp"

namespace lamina {
namespace {

constexpr std::size_t kBetweenReports = 4096;  // solids

/// Index of the first voxel whose centre is at or beyond the coordinate.
int firstVoxel(const VoxelFrame& frame, int axis, double coordinate) {
  const double index = std::ceil((coordinate - frame.corner[axis]) / frame.voxel_mm - 0.5);
  return static_cast<int>(std::clamp(index, 0.0, double(frame.count[static_cast<std::size_t>(axis)])));
}

void fillRow(VoxelGrid& grid, int from, int to, int j, int k) {
  constexpr int kWord = VoxelGrid::kWord;
  for (int w = from / kWord; w * kWord < to; ++w) {
    const int first = std::max(from - w * kWord, 0), last = std::min(to - w * kWord, kWord);
    const std::uint64_t below_last = last == kWord ? ~std::uint64_t{0} : (std::uint64_t{1} << last) - 1;
    grid.fillWord(w, j, k, below_last & ~((std::uint64_t{1} << first) - 1));
  }
}

void fillSolid(VoxelGrid& grid, const BeadSolid& solid) {
  const VoxelFrame& frame = grid.frame();
  const Box3 box = solid.box();
  const int last_k = firstVoxel(frame, 2, box.high.z()), last_j = firstVoxel(frame, 1, box.high.y());
  for (int k = firstVoxel(frame, 2, box.low.z()); k < last_k; ++k)
    for (int j = firstVoxel(frame, 1, box.low.y()); j < last_j; ++j) {
      const Point3 centre = frame.centre(0, j, k);
      const auto stretch = solid.alongX(centre.y(), centre.z());
      if (!stretch) continue;
      fillRow(grid, firstVoxel(frame, 0, stretch->from), firstVoxel(frame, 0, stretch->to), j, k);
    }
}

/// The solids near a place, from cells that hold them.
class SolidCells {
 public:
  /// @param reach_mm  within which solids are found
  SolidCells(const std::vector<BeadSolid>& solids, const Point3& corner, double reach_mm)
      : solids_(solids), corner_(corner), cell_mm_(8.0 * reach_mm) {
    for (std::size_t i = 0; i < solids.size(); ++i) insert(static_cast<std::uint32_t>(i), reach_mm);
  }

  /// Greatest depth of the point in one of them; negative outside.
  double depth(const Point3& point) const {
    const auto cell = cells_.find(key(indexOf(point)));
    double deepest = -cell_mm_;
    if (cell == cells_.end()) return deepest;
    for (const std::uint32_t i : cell->second) deepest = std::max(deepest, solids_[i].depth(point));
    return deepest;
  }

 private:
  using Index = Eigen::Matrix<std::int64_t, 3, 1>;

  Index indexOf(const Point3& point) const {
    return ((point - corner_) / cell_mm_).array().floor().matrix().cast<std::int64_t>();
  }
  /// 21 bits an axis.
  static std::uint64_t key(const Index& index) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key = key << 21U | (static_cast<std::uint64_t>(index[axis] + (1 << 20)) & 0x1FFFFFU);
    return key;
  }

  /// A long solid that lies askew would be in all cells of its box, so it goes in stretch by stretch.
  void insert(std::uint32_t i, double reach_mm) {
    const auto grow = Point3::Constant(reach_mm);
    for (const Box3& box : solids_[i].stretchBoxes(cell_mm_)) {
      const Index low = indexOf(box.low - grow), high = indexOf(box.high + grow);
      for (std::int64_t z = low.z(); z <= high.z(); ++z)
        for (std::int64_t y = low.y(); y <= high.y(); ++y)
          for (std::int64_t x = low.x(); x <= high.x(); ++x) {
            std::vector<std::uint32_t>& held = cells_[key({x, y, z})];
            if (held.empty() || held.back() != i) held.push_back(i);
          }
    }
  }

  const std::vector<BeadSolid>& solids_;
  Point3 corner_;
  double cell_mm_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace

Box3 unionBox(const std::vector<BeadSolid>& solids) {
  Box3 box;
  for (const BeadSolid& solid : solids) {
    const Box3 own = solid.box();
    box.include(own.low);
    box.include(own.high);
  }
  return box;
}

VoxelGrid voxelUnion(const std::vector<BeadSolid>& solids, double voxel_mm, Progress& progress) {
  VoxelGrid grid(voxelFrame(unionBox(solids), voxel_mm));
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (i % kBetweenReports == 0) {
      throwIfCancelled(progress, "sweep");
      progress.report("sweep", static_cast<double>(i) / static_cast<double>(solids.size()));
    }
    fillSolid(grid, solids[i]);
  }
  return grid;
}

Mesh unionSurface(const std::vector<BeadSolid>& solids, const VoxelGrid& inside) {
  const VoxelFrame& frame = inside.frame();
  // Vertices at one lattice point would become one in a file of single precision.
  const double least = 0.01 * frame.voxel_mm;
  const SolidCells cells(solids, frame.corner, frame.voxel_mm);
  return isosurface(inside, [&](int i, int j, int k) {
    const double depth = cells.depth(frame.centre(i, j, k));
    return inside.isSolid(i, j, k) ? std::max(depth, least) : std::min(depth, -least);
  });
}

}  // namespace lamina
