// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/cells_beside.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/geometry/shortest_rotation.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"

namespace lamina {
namespace {

constexpr double kBeadReach = 1.25;   // bead widths
constexpr double kFoldedReach = 2.0;  // bead widths along the same path, below which it is the same bead

/// Whether two cells are of beads that lie side by side, the numbers of their runs given.
bool areOfTwoBeads(const LayerCells& cells, std::size_t cell, std::size_t run, std::size_t other,
                   std::size_t run_of_other) {
  if (run != run_of_other) return true;
  const CellRun& path = cells.runs[run];
  double apart = std::abs(cells.along_mm[cell] - cells.along_mm[other]);
  if (path.is_closed) apart = std::min(apart, path.length_mm - apart);
  return apart > kFoldedReach * cells.width_mm[cell];
}

std::vector<std::uint32_t> runOfCells(const LayerCells& cells) {
  std::vector<std::uint32_t> run_of(cells.size());
  for (std::size_t r = 0; r < cells.runs.size(); ++r)
    std::fill_n(run_of.begin() + static_cast<std::ptrdiff_t>(cells.runs[r].first), cells.runs[r].count,
                static_cast<std::uint32_t>(r));
  return run_of;
}

}  // namespace

Eigen::Matrix<double, 2, 3> planeSquareTo(const Eigen::Vector3d& normal) {
  const Eigen::Quaterniond turn = shortestRotation(normal, Eigen::Vector3d::UnitZ());
  return turn.toRotationMatrix().topRows<2>();
}

std::vector<CellsBeside> cellsBeside(const LayerCells& cells, const Eigen::Vector3d& normal) {
  std::vector<CellsBeside> beside(cells.size());
  if (cells.size() == 0) return beside;
  const double widest = *std::max_element(cells.width_mm.begin(), cells.width_mm.end());
  if (!(widest > 0.0)) return beside;
  const Eigen::Matrix<double, 2, 3> plane = planeSquareTo(normal);
  const std::vector<std::uint32_t> run_of = runOfCells(cells);
  Box2 box;
  for (const Point3& middle : cells.middle) box.include(Point2(plane * middle));
  PointGrid grid(box, widest);
  for (const Point3& middle : cells.middle) grid.insert(plane * middle);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double reach = kBeadReach * cells.width_mm[i];
    const Eigen::Vector3d across = cells.growth[i].cross(cells.tangent[i]);
    double nearest[2] = {reach * reach, reach * reach};
    std::uint32_t found[2] = {CellsBeside::kNone, CellsBeside::kNone};
    grid.visitNear(grid.points()[i], reach, [&](std::uint32_t other, double) {
      const Eigen::Vector3d way = cells.middle[other] - cells.middle[i];
      const double squared = way.squaredNorm();
      const std::size_t side = way.dot(across) >= 0.0 ? 0 : 1;
      if (squared > nearest[side] || (squared == nearest[side] && other > found[side])) return;
      if (!areOfTwoBeads(cells, i, run_of[i], other, run_of[other])) return;
      nearest[side] = squared;
      found[side] = other;
    });
    beside[i] = {found[0], found[1], static_cast<float>(std::sqrt(nearest[0])),
                 static_cast<float>(std::sqrt(nearest[1]))};
  }
  return beside;
}

}  // namespace lamina
