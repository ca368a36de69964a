// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/overhang/deposited_beads.hpp"

#include <algorithm>

#include "toolpath/bead_space.hpp"

namespace lamina {

bool lays(const Path& path) {
  const std::vector<Bead>& beads = path.bead.values();
  return path.role != PathRole::Travel && std::any_of(beads.begin(), beads.end(), [](const Bead& bead) {
           return bead.width_mm > 0.0 && bead.height_mm > 0.0;
         });
}

DepositedBeads depositedBeads(const Toolpath& toolpath) {
  const Eigen::Matrix3d layers_from_part = toolpath.part_from_layers.conjugate().toRotationMatrix();
  DepositedBeads deposited;
  for (const ToolpathLayer& layer : toolpath.layers) {
    deposited.first_of_layer.push_back(deposited.beads.size());
    for (const Path& path : layer.paths)
      forEachBead(path, [&](const DepositedSegment& segment) {
        const auto middle = [&](const Point3& tip) {
          return sectionMiddle(layers_from_part * tip, segment.bead.height_mm, Point3::UnitZ());
        };
        deposited.beads.push_back({middle(segment.start), middle(segment.end), segment.bead});
      });
  }
  deposited.first_of_layer.push_back(deposited.beads.size());
  return deposited;
}

}  // namespace lamina
