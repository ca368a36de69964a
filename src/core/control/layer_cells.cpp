// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/layer_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/shortest_rotation.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"

namespace lamina {

bool hasCells(const Path& path) {
  return path.deposit == Deposit::Bead && path.role != PathRole::Travel &&
         kindOf(path.role) != RoleKind::BuildAid && path.motionCount() > 0;
}

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

/// Two unit vectors square to a normal and to each other, as rows.
Eigen::Matrix<double, 2, 3> planeSquareTo(const Eigen::Vector3d& normal) {
  const Eigen::Quaterniond turn = shortestRotation(normal, Eigen::Vector3d::UnitZ());
  return turn.toRotationMatrix().topRows<2>();
}

/// The values of `LayerCells::beside`. Of equally near cells the one deposited first is taken.
/// @param normal  of the layers: distances are those in the plane square to it
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

constexpr double kCornerCosine = 0.866;  // turns of more than 30 degrees
constexpr double kLeastSquare = 0.1;     // of a tool axis across its path, to show the growth
constexpr double kSamePlane = 1e-6;      // mm

/// How the cells of a layer grow.
struct Growth {
  Eigen::Vector3d normal;
  bool is_plane;
};

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
  std::vector<std::size_t> motions;  // a point that stands twice has no direction
  for (std::size_t m = 0; m < measured.path.motionCount(); ++m)
    if (measured.along[m + 1] > measured.along[m]) motions.push_back(m);
  const auto turns = [&](std::size_t from, std::size_t to) {
    return measured.direction(from).dot(measured.direction(to)) < kCornerCosine;
  };
  for (std::size_t i = 0; i + 1 < motions.size(); ++i)
    if (turns(motions[i], motions[i + 1])) corners.push_back(measured.along[motions[i + 1]]);
  const bool turns_at_seam =
      measured.path.is_closed && motions.size() > 1 && turns(motions.back(), motions.front());
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

/// Whether the depositing paths lie within the layer's height of one another.
bool isPlane(const ToolpathLayer& layer, const Eigen::Vector3d& normal) {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (const Path& path : layer.paths) {
    if (!hasCells(path)) continue;
    for (const Point3& point : path.points) {
      least = std::min(least, normal.dot(point));
      greatest = std::max(greatest, normal.dot(point));
    }
  }
  return !(greatest - least > std::max(layer.height_mm, kSamePlane));
}

/// Goes along a path, forth only.
class PathWalk {
 public:
  explicit PathWalk(const MeasuredPath& measured) : measured_(measured) {}

  void goTo(double along) {
    while (motion_ + 1 < measured_.path.motionCount() && measured_.along[motion_ + 1] < along) ++motion_;
    const double length = measured_.along[motion_ + 1] - measured_.along[motion_];
    part_ = length > 0.0 ? (along - measured_.along[motion_]) / length : 0.0;
  }
  std::size_t end() const { return measured_.path.motionEnd(motion_); }  ///< waypoint of the bead here
  Point3 point() const {
    const std::vector<Point3>& points = measured_.path.points;
    return points[motion_] + part_ * (points[end()] - points[motion_]);
  }
  Eigen::Vector3d direction() const { return measured_.direction(motion_); }
  Eigen::Vector3d againstTool() const {
    const AlongPath<Eigen::Quaterniond>& held = measured_.path.orientation;
    const Eigen::Quaterniond turn =
        held.isCommon() ? held.at(0) : held.at(motion_).slerp(part_, held.at(end()));
    return turn * -Eigen::Vector3d::UnitZ();
  }

 private:
  const MeasuredPath& measured_;
  std::size_t motion_ = 0;
  double part_ = 0.0;
};

/// Against the tool axis and square to the path; where the tool lies along the path, as the normal would.
Eigen::Vector3d growthAgainst(const Eigen::Vector3d& tool, const Eigen::Vector3d& tangent,
                              const Eigen::Vector3d& normal) {
  for (const Eigen::Vector3d& direction : {tool, normal}) {
    const Eigen::Vector3d square = direction - direction.dot(tangent) * tangent;
    if (square.norm() > kLeastSquare) return square.normalized();
  }
  return tangent.unitOrthogonal();
}

/// From where the cell begins to where it ends; where the path comes back within it, as the motion goes.
Eigen::Vector3d tangentOf(const Eigen::Vector3d& chord, double length, const Eigen::Vector3d& motion) {
  return chord.norm() > 0.5 * length ? Eigen::Vector3d(chord.normalized()) : motion;
}

void addRun(LayerCells& cells, const Path& path, std::size_t index, double cell_mm, const Growth& growth) {
  const MeasuredPath measured(path);
  if (!(measured.length() > 0.0)) return;
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(measured.length() / cell_mm - 1e-9)));
  const std::vector<double> corners = cornersOf(measured);
  cells.runs.push_back({index, cells.size(), count, measured.length(), path.is_closed});
  const double each = measured.length() / static_cast<double>(count);
  PathWalk walk(measured);
  Point3 begin = path.firstPoint();
  for (std::size_t i = 0; i < count; ++i) {
    const double along = (static_cast<double>(i) + 0.5) * measured.length() / static_cast<double>(count);
    walk.goTo(along);
    const std::size_t end = walk.end();
    const Eigen::Vector3d motion = walk.direction();
    const Eigen::Vector3d against_tool = walk.againstTool();
    cells.middle.emplace_back(walk.point());
    cells.along_mm.push_back(along);
    cells.height_mm.push_back(path.bead.at(end).height_mm);
    cells.width_mm.push_back(path.bead.at(end).width_mm);
    cells.speed_mm_s.push_back(path.feed_mm_s.at(end));
    cells.region.push_back(regionAt(along, measured, corners));
    walk.goTo(std::min(along + 0.5 * each, measured.length()));
    const Eigen::Vector3d tangent = tangentOf(walk.point() - begin, each, motion);
    begin = walk.point();
    cells.tangent.push_back(tangent);
    cells.growth.push_back(growth.is_plane ? growth.normal
                                           : growthAgainst(against_tool, tangent, growth.normal));
  }
}

}  // namespace

LayerCells layerCells(const ToolpathLayer& layer, std::size_t index, double cell_mm,
                      const Eigen::Vector3d& normal) {
  if (!(cell_mm > 0.0) || !std::isfinite(cell_mm))
    throw InvalidInput("cells are " + numberText(cell_mm) + " mm long; expected a positive length");
  LayerCells cells;
  cells.layer = index;
  const Growth growth{normal, isPlane(layer, normal)};
  for (std::size_t p = 0; p < layer.paths.size(); ++p) {
    const std::size_t runs = cells.runs.size();
    if (hasCells(layer.paths[p])) addRun(cells, layer.paths[p], p, cell_mm, growth);
    const bool is_run = cells.runs.size() > runs;
    if (is_run) cells.runs.back().is_after_other = cells.ends_with_other;
    if (is_run || layer.paths[p].role != PathRole::Travel) cells.ends_with_other = !is_run;
  }
  cells.beside = cellsBeside(cells, normal);
  return cells;
}

namespace {

/// How a cell looks for the one that it lies on.
struct BelowQuery {
  Point3 at = Point3::Zero();
  bool is_tilted = false;  ///< whether the cell grows otherwise than its layer
};

/// Cells of layers that are not plane lie a layer's height above what they lie on along their own growth,
/// which may be square to the layers' normal.
BelowQuery belowQuery(const LayerCells& layer, std::size_t cell, const Eigen::Vector3d& normal) {
  constexpr double kSameGrowth = 1e-9;
  const Eigen::Vector3d& growth = layer.growth[cell];
  if ((growth - normal).squaredNorm() <= kSameGrowth * kSameGrowth) return {layer.middle[cell], false};
  return {layer.middle[cell] - layer.height_mm[cell] * growth, true};
}

}  // namespace

std::vector<std::uint32_t> cellsBelow(const LayerCells& layer, const LayerCells& below,
                                      const Eigen::Vector3d& normal) {
  std::vector<std::uint32_t> found(layer.size(), kNoCellBelow);
  if (below.size() == 0) return found;
  const Eigen::Matrix<double, 2, 3> plane = planeSquareTo(normal);
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
    const BelowQuery query = belowQuery(layer, i, normal);
    grid.visitNear(plane * query.at, layer.width_mm[i], [&](std::uint32_t cell, double squared) {
      if (query.is_tilted) squared = (below.middle[cell] - query.at).squaredNorm();
      // Of cells that are equally near the one deposited first: kNoCellBelow is greater than all.
      if (squared > least || (squared == least && cell > found[i])) return;
      least = squared;
      found[i] = cell;
    });
  }
  return found;
}

Eigen::Vector3d normalOfLayers(const Toolpath& toolpath) {
  return toolpath.part_from_layers * Eigen::Vector3d::UnitZ();
}

std::size_t cellsPassed(const LayerCells& cells, std::size_t path, double along_mm, double settle_mm) {
  double behind = 0.0;  // deposited since the end of the run
  std::size_t passed = 0;
  for (auto run = cells.runs.rbegin(); run != cells.runs.rend(); ++run) {
    if (run->path > path) continue;
    const double deposited = run->path == path ? std::clamp(along_mm, 0.0, run->length_mm) : run->length_mm;
    const double settled = deposited - std::max(0.0, settle_mm - behind);
    const double count = std::floor(settled / run->cellLength() + 1e-9);
    if (count >= 1.0) {
      passed = run->first + std::min(run->count, static_cast<std::size_t>(count));
      break;
    }
    behind += deposited;
  }
  return passed;
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
