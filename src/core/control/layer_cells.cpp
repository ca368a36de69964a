// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/layer_cells.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"

namespace lamina {
namespace {

constexpr double kCornerCosine = 0.866;  // turns of more than 30 degrees

/// Waypoints of a path with the lengths up to them, the return of a closed one included.
struct MeasuredPath {
  const Path& path;
  std::vector<double> along;  ///< at which motion m begins; one more than there are motions

  explicit MeasuredPath(const Path& measured) : path(measured), along(1, 0.0) {
    for (std::size_t m = 0; m < path.motionCount(); ++m)
      along.push_back(along.back() + (path.points[path.motionEnd(m)] - path.points[m]).norm());
  }
  double length() const { return along.back(); }
  Point3 direction(std::size_t motion) const {
    return (path.points[path.motionEnd(motion)] - path.points[motion]).normalized();
  }
};

std::vector<double> cornersOf(const MeasuredPath& measured) {
  std::vector<double> corners;
  const std::size_t motions = measured.path.motionCount();
  for (std::size_t m = 0; m + 1 < motions; ++m)
    if (measured.direction(m).dot(measured.direction(m + 1)) < kCornerCosine)
      corners.push_back(measured.along[m + 1]);
  const bool turns_at_seam = measured.path.is_closed && motions > 1 &&
                             measured.direction(motions - 1).dot(measured.direction(0)) < kCornerCosine;
  if (turns_at_seam) corners.insert(corners.begin(), 0.0);
  if (turns_at_seam) corners.push_back(measured.length());
  return corners;
}

CellRegion regionAt(double along, const MeasuredPath& measured, const std::vector<double>& corners) {
  const bool is_at_end =
      !measured.path.is_closed && std::min(along, measured.length() - along) < kRegionReach;
  if (is_at_end) return CellRegion::End;
  const auto next = std::lower_bound(corners.begin(), corners.end(), along);
  const bool is_before = next != corners.end() && *next - along < kRegionReach;
  const bool is_after = next != corners.begin() && along - *(next - 1) < kRegionReach;
  return is_before || is_after ? CellRegion::Corner : CellRegion::Straight;
}

bool hasCells(const Path& path) {
  return path.deposit == Deposit::Bead && path.role != PathRole::Travel &&
         kindOf(path.role) != RoleKind::BuildAid && path.motionCount() > 0;
}

void addRun(LayerCells& cells, const Path& path, std::size_t index, double cell_mm) {
  const MeasuredPath measured(path);
  if (!(measured.length() > 0.0)) return;
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(measured.length() / cell_mm - 1e-9)));
  const std::vector<double> corners = cornersOf(measured);
  cells.runs.push_back({index, cells.size(), count, measured.length(), path.is_closed});
  std::size_t motion = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double along = (static_cast<double>(i) + 0.5) * measured.length() / static_cast<double>(count);
    while (motion + 1 < path.motionCount() && measured.along[motion + 1] < along) ++motion;
    const double length = measured.along[motion + 1] - measured.along[motion];
    const double part = length > 0.0 ? (along - measured.along[motion]) / length : 0.0;
    const std::size_t end = path.motionEnd(motion);
    cells.middle.emplace_back(path.points[motion] + part * (path.points[end] - path.points[motion]));
    cells.along_mm.push_back(along);
    cells.height_mm.push_back(path.bead.at(end).height_mm);
    cells.width_mm.push_back(path.bead.at(end).width_mm);
    cells.speed_mm_s.push_back(path.feed_mm_s.at(end));
    cells.region.push_back(regionAt(along, measured, corners));
  }
}

Eigen::Matrix<double, 2, 3> planeOf(const Eigen::Vector3d& normal) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(normal, Eigen::Vector3d::UnitZ());
  return turn.toRotationMatrix().topRows<2>();
}

}  // namespace

LayerCells layerCells(const ToolpathLayer& layer, std::size_t index, double cell_mm) {
  if (!(cell_mm > 0.0) || !std::isfinite(cell_mm))
    throw InvalidInput("cells are " + std::to_string(cell_mm) + " mm long; expected a positive length");
  LayerCells cells;
  cells.layer = index;
  for (std::size_t p = 0; p < layer.paths.size(); ++p)
    if (hasCells(layer.paths[p])) addRun(cells, layer.paths[p], p, cell_mm);
  return cells;
}

std::vector<std::uint32_t> cellsBelow(const LayerCells& layer, const LayerCells& below,
                                      const Eigen::Vector3d& normal) {
  std::vector<std::uint32_t> found(layer.size(), kNoCellBelow);
  if (below.size() == 0) return found;
  const Eigen::Matrix<double, 2, 3> plane = planeOf(normal);
  Box2 box;
  double widest = 0.0;
  for (std::size_t i = 0; i < below.size(); ++i) {
    box.include(Point2(plane * below.middle[i]));
    widest = std::max(widest, below.width_mm[i]);
  }
  PointGrid grid(box, std::max(widest, 1e-3));
  for (const Point3& middle : below.middle) grid.insert(plane * middle);
  for (std::size_t i = 0; i < layer.size(); ++i) {
    double least = layer.width_mm[i] * layer.width_mm[i];
    grid.visitNear(plane * layer.middle[i], layer.width_mm[i], [&](std::uint32_t cell, double squared) {
      // Of cells that are equally near the one laid first: kNoCellBelow is greater than all.
      if (squared > least || (squared == least && cell > found[i])) return;
      least = squared;
      found[i] = cell;
    });
  }
  return found;
}

double meanOverCells(const LayerCells& cells, const std::vector<double>& values) {
  double sum = 0.0;
  double length = 0.0;
  for (const CellRun& run : cells.runs) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i) sum += values[i] * run.cellLength();
    length += run.length_mm;
  }
  return length > 0.0 ? sum / length : 0.0;
}

}  // namespace lamina
