// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/expected_surface.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/geometry/spatial/cells_near_segment.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {

ExpectedSurface::ExpectedSurface(const HeightGrid& grid, const Eigen::Isometry3d& heights_from_part)
    : heights_(grid), heights_from_part_(heights_from_part), top_in_layer_(grid.cellCount(), 0) {}

void ExpectedSurface::addLayer(const ToolpathLayer& layer) {
  ++layers_;
  top_cells_.clear();
  for (const Path& path : layer.paths)
    forEachDepositedSegment(path, [&](const DepositedSegment& segment) {
      addMotion(heights_from_part_ * segment.start, heights_from_part_ * segment.end, segment.bead,
                path.role);
    });
}

void ExpectedSurface::addMotion(const Point3& start, const Point3& end, const Bead& bead, PathRole role) {
  const HeightGrid& grid = heights_.grid();
  const double flat = std::max(0.5 * (bead.width_mm - bead.height_mm), 0.5 * grid.cell_mm);
  const double reach = std::max(flat, 0.5 * bead.width_mm);
  const bool is_aid = kindOf(role) == RoleKind::BuildAid;
  forCellsNearSegment(grid, start.head<2>(), end.head<2>(), reach,
                      [&](std::size_t cell, double distance, double along) {
                        const double z = start.z() + along * (end.z() - start.z());
                        const double before = heights_.at(cell);
                        if (!(before >= z)) heights_.set(cell, z);
                        if (is_aid || distance > flat || top_in_layer_[cell] == layers_) return;
                        top_in_layer_[cell] = layers_;
                        top_cells_.push_back(cell);
                      });
}

}  // namespace lamina
