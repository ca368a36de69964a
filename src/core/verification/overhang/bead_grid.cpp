// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/overhang/bead_grid.hpp"

#include <limits>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/spatial/cells_near_segment.hpp"

namespace lamina {
namespace {

constexpr double kMostCells = 4e6;
constexpr double kMostLayers = 1e5;
constexpr double kWidthsPerCell = 2.5;  // a few beads of a layer cross a cell
constexpr double kHalfDiagonal = 0.7072;

}  // namespace

BeadGrid::BeadGrid(const std::vector<DepositedBead>& beads, double margin_mm) {
  if (beads.size() > std::numeric_limits<std::uint32_t>::max())
    throw InvalidInput("the toolpath has " + std::to_string(beads.size()) + " beads; at most 4294967295 fit");
  Box3 box;
  Bead largest;
  for (const DepositedBead& bead : beads) {
    box.include(bead.start);
    box.include(bead.end);
    largest.width_mm = std::max(largest.width_mm, bead.section.width_mm);
    largest.height_mm = std::max(largest.height_mm, bead.section.height_mm);
  }
  if (box.isEmpty()) return;
  const double around = 0.5 * largest.width_mm + margin_mm;
  layOut({box.low - Point3(around, around, 0.0), box.high + Point3(around, around, 0.0)}, largest);
  for (std::size_t i = 0; i < beads.size(); ++i) put(beads[i], static_cast<std::uint32_t>(i), margin_mm);
  NoProgress nobody;
  parallelFor(
      layer_bounds_.size(),
      [this](std::size_t i) { std::sort(layer_bounds_[i].begin(), layer_bounds_[i].end()); }, nobody,
      "overhang");
}

void BeadGrid::layOut(const Box3& box, const Bead& largest) {
  const Point3 size = box.size();
  // One more cell on each side of the plane, for what rounding puts on the edge.
  const double fewest = std::sqrt(size.x() * size.y() / kMostCells);
  cells_.cell_mm =
      std::max({kWidthsPerCell * largest.width_mm, fewest, size.x() / kMostCells, size.y() / kMostCells});
  cells_.origin = box.low.head<2>();
  cells_.columns = 1 + static_cast<int>(size.x() / cells_.cell_mm);
  cells_.rows = 1 + static_cast<int>(size.y() / cells_.cell_mm);
  low_z_ = box.low.z();
  bounds_mm_ = std::max(largest.height_mm, size.z() / kMostLayers);
  layer_bounds_.resize(1 + static_cast<std::size_t>(size.z() / bounds_mm_));
}

void BeadGrid::put(const DepositedBead& bead, std::uint32_t index, double margin_mm) {
  const double reach = 0.5 * bead.section.width_mm + margin_mm + kHalfDiagonal * cells_.cell_mm;
  const auto [low, high] = std::minmax(bead.start.z(), bead.end.z());
  const std::size_t last = boundsOf(high);
  for (std::size_t bounds = boundsOf(low); bounds <= last; ++bounds)
    forCellsNearSegment(cells_, bead.start.head<2>(), bead.end.head<2>(), reach,
                        [&](std::size_t cell, double, double) {
                          layer_bounds_[bounds].push_back({static_cast<std::uint32_t>(cell), index});
                        });
}

std::size_t BeadGrid::boundsOf(double z) const {
  const double bounds = std::floor((z - low_z_) / bounds_mm_);
  return static_cast<std::size_t>(std::clamp(bounds, 0.0, static_cast<double>(layer_bounds_.size() - 1)));
}

}  // namespace lamina
