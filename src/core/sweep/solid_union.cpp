// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/solid_union.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/spatial/box_cells.hpp"
#include "lamina/geometry/voxel/isosurface.hpp"

namespace lamina {
namespace {

constexpr std::size_t kBetweenReports = 4096;  // solids
constexpr double kCellVoxels = 8.0;            // edge of a cell
constexpr double kLeastShare = 1e-6;           // of all that a cell measures

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

/// The solids near a place.
class SolidCells {
 public:
  /// @param frame  of places; solids are found within a voxel
  SolidCells(const std::vector<BeadSolid>& solids, const VoxelFrame& frame)
      : solids_(solids), far_mm_(kCellVoxels * frame.voxel_mm), cells_(cellsOf(solids, frame)) {}

  /// Greatest depth of the point in one of them; negative outside.
  double depth(const Point3& point) const {
    double deepest = -far_mm_;
    for (const std::uint32_t i : cells_.near(point)) deepest = std::max(deepest, solids_[i].depth(point));
    return deepest;
  }

 private:
  /// A long solid that lies askew would be in all cells of its box, so it goes in stretch by stretch.
  /// Cells begin on the frame, since beyond a voxel a depth is not exact and depends on what else is found.
  static BoxCells cellsOf(const std::vector<BeadSolid>& solids, const VoxelFrame& frame) {
    const Point3 grow = Point3::Constant(frame.voxel_mm);
    const Box3 all = unionBox(solids);
    const double cell_mm = std::max(kCellVoxels * frame.voxel_mm, kLeastShare * all.size().maxCoeff());
    const Box3 space{frame.corner - Point3::Constant(cell_mm), all.high + grow};
    return BoxCells({CellKind::Cubes, space, cell_mm}, [&](const auto& put) {
      for (std::uint32_t i = 0; i < solids.size(); ++i)
        for (const Box3& box : solids[i].stretchBoxes(cell_mm)) put(i, {box.low - grow, box.high + grow});
    });
  }

  const std::vector<BeadSolid>& solids_;
  double far_mm_;
  BoxCells cells_;
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
  const SolidCells cells(solids, frame);
  return isosurface(inside, [&](int i, int j, int k) {
    const double depth = cells.depth(frame.centre(i, j, k));
    return inside.isSolid(i, j, k) ? std::max(depth, least) : std::min(depth, -least);
  });
}

}  // namespace lamina
