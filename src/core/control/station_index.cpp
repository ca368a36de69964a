// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/station_index.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/geometry/shortest_rotation.hpp"

namespace lamina {
namespace {

constexpr double kMostSquares = 4e6;
constexpr double kMostCubesPerAxis = 1 << 20;
constexpr double kLeastCosine = 0.5;     // of growth to the plane's normal
constexpr double kLeastEdge = 1e-3;      // mm
constexpr double kSameDirection = 1e-9;  // of unit vectors
constexpr double kGapeReach = 1.53;      // half lengths that a cell reaches where it gapes
constexpr double kAcross = 0.51;         // bead widths that it reaches
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
  begin_.assign(1, 0);
  if (cells.size() == 0) return;
  layOut(cells);
  const auto squares = static_cast<std::size_t>(has_squares_ ? count_[0] * count_[1] : 0);
  begin_.assign(squares + 1, 0);
  if (!has_squares_) table_.resize(1024);
  visitPlaces(cells, [&](std::uint32_t, std::uint64_t key) {
    const std::uint32_t number = numberedAs(key);
    if (number + 2 > begin_.size()) begin_.push_back(0);
    ++begin_[number];
  });
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : begin_) begin = std::exchange(sum, sum + begin);
  cells_.resize(sum);
  std::vector<std::uint32_t> next = begin_;
  visitPlaces(cells, [&](std::uint32_t cell, std::uint64_t key) { cells_[next[numberOf(key)]++] = cell; });
}

void StationIndex::layOut(const LayerCells& cells) {
  is_plane_ = growsAlongOne(cells);
  const Eigen::Vector3d normal = is_plane_ ? cells.growth.front() : meanGrowth(cells);
  has_squares_ = std::all_of(cells.growth.begin(), cells.growth.end(), [&](const Eigen::Vector3d& growth) {
    return growth.dot(normal) >= kLeastCosine;
  });
  if (has_squares_) axes_ = shortestRotation(normal, Eigen::Vector3d::UnitZ()).matrix();
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
  double edge = has_squares_ ? std::sqrt(longest * widest) : std::max(longest, widest);
  if (has_squares_)
    edge = std::max({edge, std::sqrt(size.x() * size.y() / kMostSquares), size.maxCoeff() / kMostSquares});
  edge = std::max(edge, size.maxCoeff() / kMostCubesPerAxis);
  low_ = box.low;
  per_mm_ = 1.0 / edge;
  for (int axis = 0; axis < 3; ++axis)
    count_[static_cast<std::size_t>(axis)] = 1 + static_cast<std::int64_t>(size[axis] * per_mm_);
  if (has_squares_) count_[2] = 1;
}

/// Half the size of the cell's box, in the axes of the index.
Point3 StationIndex::reachOf(const LayerCells& cells, const CellRun& run, std::size_t cell) const {
  const Eigen::Vector3d across = cells.growth[cell].cross(cells.tangent[cell]);
  const Point3 along = kGapeReach * 0.5 * run.cellLength() * (axes_ * cells.tangent[cell]);
  const Point3 up = window_layers_ * cells.height_mm[cell] * (axes_ * cells.growth[cell]);
  return along.cwiseAbs() + kAcross * cells.width_mm[cell] * (axes_ * across).cwiseAbs() + up.cwiseAbs();
}

StationIndex::Place StationIndex::squareAt(const Point3& offset) const {
  Place place{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double along = std::floor(offset[static_cast<Eigen::Index>(axis)] * per_mm_);
    place[axis] = std::clamp(static_cast<std::int64_t>(along), std::int64_t{0}, count_[axis] - 1);
  }
  return place;
}

/// Calls visit(cell, key) for all cells and the squares or cubes that their boxes reach.
template <class Visit>
void StationIndex::visitPlaces(const LayerCells& cells, Visit visit) const {
  for (const CellRun& run : cells.runs) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      const Point3 middle = placeOf(cells.middle[i]);
      const Point3 reach = reachOf(cells, run, i);
      const Place first = squareAt(middle - kWithin * reach);
      const Place last = squareAt(middle + kWithin * reach);
      Place place{};
      for (place[2] = first[2]; place[2] <= last[2]; ++place[2])
        for (place[1] = first[1]; place[1] <= last[1]; ++place[1])
          for (place[0] = first[0]; place[0] <= last[0]; ++place[0])
            visit(static_cast<std::uint32_t>(i), keyOf(place));
    }
  }
}

std::uint32_t StationIndex::numberedAs(std::uint64_t key) {
  const std::uint32_t known = numberOf(key);
  if (known != kNone) return known;
  if (2 * static_cast<std::size_t>(cubes_ + 1) > table_.size()) grow();
  const std::size_t mask = table_.size() - 1;
  std::size_t at = (key * kSpread >> 32U) & mask;
  while (table_[at].number != kNone) at = (at + 1) & mask;
  table_[at] = {key, cubes_};
  return cubes_++;
}

void StationIndex::grow() {
  std::vector<Cube> larger(2 * table_.size());
  const std::size_t mask = larger.size() - 1;
  for (const Cube& cube : table_) {
    if (cube.number == kNone) continue;
    std::size_t at = (cube.key * kSpread >> 32U) & mask;
    while (larger[at].number != kNone) at = (at + 1) & mask;
    larger[at] = cube;
  }
  table_ = std::move(larger);
}

std::size_t StationIndex::bytes() const {
  return sizeof(std::uint32_t) * (begin_.capacity() + cells_.capacity()) + sizeof(Cube) * table_.capacity();
}

}  // namespace lamina
