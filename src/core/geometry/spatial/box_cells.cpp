// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/spatial/box_cells.hpp"

namespace lamina {
namespace {

constexpr std::size_t kFirstTable = 64;

}  // namespace

void BoxCells::layOut(const CellSpace& space) {
  kind_ = space.kind;
  low_ = space.box.low;
  per_mm_ = 1.0 / space.cell_mm;
  const Point3 size = space.box.size();
  for (int axis = 0; axis < 3; ++axis)
    count_[static_cast<std::size_t>(axis)] = 1 + static_cast<std::int64_t>(size[axis] * per_mm_);
  if (kind_ == CellKind::Cubes) {
    table_.resize(kFirstTable);
    return;
  }
  count_[2] = 1;
  begin_.assign(static_cast<std::size_t>(count_[0] * count_[1]) + 1, 0);
}

/// Within the space.
BoxCells::Place BoxCells::placeAt(const Point3& point) const {
  Place place{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double along = std::floor((point[a] - low_[a]) * per_mm_);
    place[axis] = std::clamp(static_cast<std::int64_t>(along), std::int64_t{0}, count_[axis] - 1);
  }
  return place;
}

std::uint32_t BoxCells::numberedAs(std::uint64_t key) {
  const std::uint32_t known = numberOf(key);
  if (known != kNone) return known;
  if (2 * static_cast<std::size_t>(cubes_ + 1) > table_.size()) grow();
  const std::size_t mask = table_.size() - 1;
  std::size_t at = (key * kSpread >> 32U) & mask;
  while (table_[at].number != kNone) at = (at + 1) & mask;
  table_[at] = {key, cubes_};
  return cubes_++;
}

void BoxCells::grow() {
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

}  // namespace lamina
