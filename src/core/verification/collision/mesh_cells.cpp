// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/collision/mesh_cells.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace lamina {
namespace {

constexpr double kAlong = 48.0;      // cells along the longest side
constexpr double kRounding = 1e-6;   // mm, by which cells are taken larger
constexpr std::size_t kMost = 1000;  // cells of a box that are looked at

/// Whether every edge has equally many triangles in both directions.
bool isClosed(const Mesh& mesh) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Edge> up;
  std::vector<Edge> down;
  up.reserve(2 * mesh.triangles.size());
  down.reserve(2 * mesh.triangles.size());
  for (const Triangle& corners : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = corners[i];
      const std::uint32_t to = corners[(i + 1) % 3];
      if (from < to) up.emplace_back(from, to);
      if (to < from) down.emplace_back(to, from);
    }
  std::sort(up.begin(), up.end());
  std::sort(down.begin(), down.end());
  return up == down;
}

/// Whether the plane of a triangle passes a box; only where it does can the triangle come into it.
bool passesPlane(const std::array<Point3, 3>& corners, const Box3& box) {
  const Point3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double off = normal.dot(box.centre() - corners[0]);
  return std::abs(off) <= normal.cwiseAbs().dot(0.5 * box.size());
}

}  // namespace

std::size_t MeshCells::Range::count() const {
  std::size_t cells = 1;
  for (std::size_t i = 0; i < 3; ++i) cells *= static_cast<std::size_t>(std::max(0, last[i] - first[i] + 1));
  return cells;
}

MeshCells::MeshCells(const Mesh& mesh) : inside_(mesh), is_closed_(isClosed(mesh)) {
  for (const Triangle& corners : mesh.triangles)
    for (const std::uint32_t corner : corners) bounds_.include(mesh.vertices[corner]);
  if (bounds_.isEmpty()) return;
  side_mm_ = std::max(bounds_.size().maxCoeff() / kAlong, kRounding);
  std::size_t cells = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    counts_[i] = 1 + static_cast<int>(bounds_.size()[static_cast<Eigen::Index>(i)] / side_mm_);
    cells *= static_cast<std::size_t>(counts_[i]);
  }
  states_ = std::vector<std::atomic<State>>(cells);
  for (const Triangle& corners : mesh.triangles)
    touch({mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]});
}

/// Those beyond the mesh's bounds are left out.
MeshCells::Range MeshCells::cellsOf(const Box3& box) const {
  Range range;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const double most = counts_[i];
    const double low = std::floor((box.low[axis] - kRounding - bounds_.low[axis]) / side_mm_);
    const double high = std::floor((box.high[axis] + kRounding - bounds_.low[axis]) / side_mm_);
    range.first[i] = static_cast<int>(std::clamp(low, 0.0, most));
    range.last[i] = static_cast<int>(std::clamp(high, -1.0, most - 1.0));
  }
  return range;
}

std::size_t MeshCells::indexOf(const Cell& cell) const {
  const auto number = [](int value) { return static_cast<std::size_t>(value); };
  return (number(cell[0]) * number(counts_[1]) + number(cell[1])) * number(counts_[2]) + number(cell[2]);
}

Box3 MeshCells::boxOf(const Cell& cell) const {
  const Point3 low = bounds_.low + side_mm_ * Point3(cell[0], cell[1], cell[2]);
  return {low - Point3::Constant(kRounding), low + Point3::Constant(side_mm_ + kRounding)};
}

void MeshCells::touch(const std::array<Point3, 3>& corners) {
  Box3 box;
  for (const Point3& corner : corners) box.include(corner);
  const Range range = cellsOf(box);
  for (int x = range.first[0]; x <= range.last[0]; ++x)
    for (int y = range.first[1]; y <= range.last[1]; ++y)
      for (int z = range.first[2]; z <= range.last[2]; ++z)
        if (passesPlane(corners, boxOf({x, y, z}))) states_[indexOf({x, y, z})] = State::Touched;
}

bool MeshCells::isFarFrom(const Box3& box) const {
  if (states_.empty()) return true;
  const Range range = cellsOf(box);
  if (range.count() > kMost) return false;
  for (int x = range.first[0]; x <= range.last[0]; ++x)
    for (int y = range.first[1]; y <= range.last[1]; ++y)
      for (int z = range.first[2]; z <= range.last[2]; ++z)
        if (states_[indexOf({x, y, z})].load(std::memory_order_relaxed) == State::Touched) return false;
  return true;
}

bool MeshCells::isWithin(const Point3& point) const {
  if (states_.empty() || (point.array() < bounds_.low.array()).any() ||
      (point.array() > bounds_.high.array()).any())
    return false;
  const Range at = cellsOf({point, point});
  std::atomic<State>& state = states_[indexOf(at.last)];
  const State known = state.load(std::memory_order_relaxed);
  if (!is_closed_ || known == State::Touched) return inside_.isWithin(point);
  if (known != State::Unknown) return known == State::Within;
  const bool is_within = inside_.isWithin(point);
  state.store(is_within ? State::Within : State::Outside, std::memory_order_relaxed);
  return is_within;
}

}  // namespace lamina
