// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/hilbert/angle_search.hpp"

#include <cmath>
#include <utility>

namespace lamina {
namespace {

bool isBetter(const FillAtAngle& a, const FillAtAngle& b) {
  return a.paths.size() != b.paths.size() ? a.paths.size() < b.paths.size() : a.covered > b.covered;
}

}  // namespace

std::vector<FillPath> fillAtBestAngle(const Regions& centre_lines, const InfillRequest& request,
                                      const FillRegionAtAngle& fill) {
  const int angles = request.settings.hilbert.angles;
  std::vector<FillPath> paths;
  for (const Region& region : centre_lines) {
    if (region.outer.empty()) continue;
    FillAtAngle best = fill(region, request, request.angle_rad);
    for (int i = 1; i < angles; ++i) {
      FillAtAngle other = fill(region, request, request.angle_rad + 0.5 * M_PI * i / angles);
      if (isBetter(other, best)) best = std::move(other);
    }
    for (FillPath& path : best.paths) paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace lamina
