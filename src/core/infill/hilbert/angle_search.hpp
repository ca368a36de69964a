// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// A region's fill at one angle.
struct FillAtAngle {
  std::vector<FillPath> paths;
  double covered = 0.0;  ///< any measure of the area covered; greater is better
};

using FillRegionAtAngle =
    std::function<FillAtAngle(const Region& centre_lines, const InfillRequest& request, double angle_rad)>;

/// Fills each region at `request.angle_rad` and at `hilbert.angles` - 1 further angles, evenly spaced within
/// a right angle. The fill with the fewest runs is kept; of several the one that covers most, then the first.
std::vector<FillPath> fillAtBestAngle(const Regions& centre_lines, const InfillRequest& request,
                                      const FillRegionAtAngle& fill);

}  // namespace lamina
