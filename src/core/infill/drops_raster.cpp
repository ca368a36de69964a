// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/drops_raster.hpp"

#include "infill/drop_fill.hpp"

namespace lamina {
namespace {

/// Evenly from end to end.
std::vector<double> evenly(double left, double right, double pitch) {
  const int count = static_cast<int>((right - left) / pitch + 1e-6);
  if (count == 0) return {0.5 * (left + right)};
  std::vector<double> places;
  for (int k = 0; k <= count; ++k) places.push_back(left + (right - left) * k / count);
  return places;
}

}  // namespace

std::vector<FillPath> dropsRaster(const Regions& regions, const InfillRequest& request) {
  const DropSettings& drops = request.settings.drops;
  const auto contours = static_cast<std::size_t>(drops.contours);
  const RasterFrame frame(request.angle_rad);
  DropFill fill(regions, drops);
  fill.addContours(regions, contours);
  fill.addLines(rasterise(fill.inside(regions, contours), lineSpacing(drops), frame), frame,
                [&](std::int64_t, double left, double right) { return evenly(left, right, drops.pitch_mm); });
  return std::move(fill).take();
}

}  // namespace lamina
