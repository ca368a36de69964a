// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/collision/nozzle_places.hpp"

#include <algorithm>
#include <cmath>

#include "verification/collision/deposited_boxes.hpp"

namespace lamina {

std::vector<NozzlePlace> nozzlePlaces(const Toolpath& toolpath, std::size_t layer, std::size_t deposited,
                                      const Eigen::Isometry3d& bed_from_part,
                                      const ClearanceSettings& settings) {
  std::vector<NozzlePlace> places;
  const std::vector<Path>& paths = toolpath.layers[layer].paths;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const Path& path = paths[p];
    places.push_back({bed_from_part * path.firstPoint(), {layer, p, 0}, deposited});
    if (!path.is_closed) deposited += piecesDepositedAt(path, 0, settings.tolerance_mm);
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t waypoint = path.motionEnd(m);
      const Point3 start = bed_from_part * path.points[m];
      const Point3 along = bed_from_part * path.points[waypoint] - start;
      const int steps = std::max(1, static_cast<int>(std::ceil(along.norm() / settings.spacing_mm)));
      for (int i = 1; i <= steps; ++i)
        places.push_back({start + static_cast<double>(i) / steps * along, {layer, p, waypoint}, deposited});
      deposited += piecesDepositedAt(path, waypoint, settings.tolerance_mm);
    }
  }
  return places;
}

}  // namespace lamina
