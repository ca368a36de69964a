// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/hybrid.hpp"

#include <utility>

#include "infill/zigzag.hpp"
#include "lamina/geometry/offset.hpp"

namespace lamina {
namespace {

/// Number of perimeters of the layer.
int perimeterCount(const InfillRequest& request) {
  const int every = request.settings.hybrid.extra_perimeter_every;
  return every > 0 && (request.layer + 1) % static_cast<std::size_t>(every) == 0 ? 2 : 1;
}

void addPerimeter(std::vector<FillPath>& paths, const Regions& centre_lines) {
  for (Polygon& loop : outlines(centre_lines))
    paths.push_back({std::move(loop), true, PathRole::OuterWall, Deposit::Bead, {}});
}

}  // namespace

std::vector<FillPath> hybrid(const Regions& regions, const InfillRequest& request) {
  std::vector<FillPath> paths;
  Regions area = regions;
  for (int k = 0; k < perimeterCount(request); ++k) {
    addPerimeter(paths, offset(area, -0.5 * request.pitch_mm));
    area = offset(area, -request.pitch_mm);
  }
  for (FillPath& run : zigzag(area, request)) paths.push_back(std::move(run));
  return paths;
}

}  // namespace lamina
