// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/toolpath/scan_height.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Layers of parallel beads 0.4 mm wide and 0.2 mm high that fill a rectangle [mm, part frame], each followed
/// by a retracted travel at its scan height.
inline Toolpath scannedPlates(const std::vector<Box2>& layers) {
  Toolpath toolpath;
  toolpath.part_name = "plates";
  for (const Box2& box : layers) {
    ToolpathLayer layer;
    layer.height_mm = 0.2;
    layer.z_mm = 0.2 * static_cast<double>(toolpath.layers.size() + 1);
    Path fill;
    fill.bead = Bead{0.4, 0.2};
    fill.feed_mm_s = 50.0;
    for (double y = box.low.y() + 0.2; y < box.high.y(); y += 0.4) {
      const bool is_forth = fill.points.size() % 4 == 0;
      fill.points.emplace_back(is_forth ? box.low.x() + 0.2 : box.high.x() - 0.2, y, layer.z_mm);
      fill.points.emplace_back(is_forth ? box.high.x() - 0.2 : box.low.x() + 0.2, y, layer.z_mm);
    }
    if (!toolpath.layers.empty()) toolpath.layers.back().paths.back().points.back() = fill.points.front();
    const double scan = scanHeight(layer, 1.0);
    Path travel;
    travel.role = PathRole::Travel;
    travel.process.is_retracted = true;
    travel.feed_mm_s = 100.0;
    const Point3 end = fill.points.back();
    travel.points = {end, {end.x(), end.y(), scan}, {box.low.x(), box.low.y(), scan}, {0.0, 0.0, scan}};
    layer.paths = {fill, travel};
    toolpath.layers.push_back(layer);
  }
  return toolpath;
}

}  // namespace lamina
