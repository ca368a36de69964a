// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/station_index.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/geometry/shortest_rotation.hpp"

namespace lamina {
namespace {

constexpr double kMostSquares = 4e6;
constexpr double kMostCubesPerAxis = 1 << 20;
constexpr double kLeastCosine = 0.5;     // of growth to the plane's normal
constexpr double kLeastEdge = 1e-3;      // mm
constexpr double kSameDirection = 1e-9;  // of unit vectors
constexpr double kGapeReach = 1.53;      // half lengths that a cell reaches where it gapes
constexpr double kWithin = 1.0 - 1e-9;   // of it: cells that end on a square's edge do not reach the next

bool growsAlongOne(const LayerCells& cells) {
  return std::all_of(cells.growth.begin(), cells.growth.end(), [&](const Eigen::Vector3d& growth) {
    return (growth - cells.growth.front()).squaredNorm() < kSameDirection * kSameDirection;
  });
}

/// The upward one where it all cancels out.
Eigen::Vector3d meanGrowth(const LayerCells& cells) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& growth : cells.growth) sum += growth;
  return sum.norm() > kSameDirection ? Eigen::Vector3d(sum.normalized()) : Eigen::Vector3d::UnitZ();
}

}  // namespace

StationIndex::StationIndex(const LayerCells& cells, double window_layers) : window_layers_(window_layers) {
  if (cells.size() == 0) return;
  const CellSpace space = layOut(cells);
  stations_ = BoxCells(space, [&](const auto& put) {
    for (const CellRun& run : cells.runs)
      for (std::size_t i = run.first; i < run.first + run.count; ++i) {
        const Point3 middle = placeOf(cells.middle[i]);
        const Point3 reach = reachOf(cells, run, i);
        put(static_cast<std::uint32_t>(i), {middle - kWithin * reach, middle + kWithin * reach});
      }
  });
}

CellSpace StationIndex::layOut(const LayerCells& cells) {
  is_plane_ = growsAlongOne(cells);
  const Eigen::Vector3d normal = is_plane_ ? cells.growth.front() : meanGrowth(cells);
  const bool has_squares =
      std::all_of(cells.growth.begin(), cells.growth.end(),
                  [&](const Eigen::Vector3d& growth) { return growth.dot(normal) >= kLeastCosine; });
  if (has_squares) axes_ = shortestRotation(normal, Eigen::Vector3d::UnitZ()).matrix();
  Box3 box;
  double longest = kLeastEdge;
  double widest = kLeastEdge;
  for (const CellRun& run : cells.runs) {
    longest = std::max(longest, run.cellLength());
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      const Point3 reach = reachOf(cells, run, i);
      const Point3 middle = axes_ * cells.middle[i];
      box.include(Point3(middle - reach));
      box.include(Point3(middle + reach));
      widest = std::max(widest, cells.width_mm[i]);
    }
  }
  const Point3 size = box.size();
  // Between length and width of a cell the lists of candidates are shortest.
  double edge = has_squares ? std::sqrt(longest * widest) : std::max(longest, widest);
  if (has_squares)
    edge = std::max({edge, std::sqrt(size.x() * size.y() / kMostSquares), size.maxCoeff() / kMostSquares});
  edge = std::max(edge, size.maxCoeff() / kMostCubesPerAxis);
  low_ = box.low;
  return {has_squares ? CellKind::Squares : CellKind::Cubes, {Point3::Zero(), size}, edge};
}

/// Half the size of the cell's box, in the axes of the index.
Point3 StationIndex::reachOf(const LayerCells& cells, const CellRun& run, std::size_t cell) const {
  const Eigen::Vector3d across = cells.growth[cell].cross(cells.tangent[cell]);
  const Point3 along = kGapeReach * 0.5 * run.cellLength() * (axes_ * cells.tangent[cell]);
  const Point3 up = window_layers_ * cells.height_mm[cell] * (axes_ * cells.growth[cell]);
  return along.cwiseAbs() + kAcross * cells.width_mm[cell] * (axes_ * across).cwiseAbs() + up.cwiseAbs();
}

}  // namespace lamina
