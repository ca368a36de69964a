// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/drops/drops_raster.hpp"

#include "infill/drops/drop_fill.hpp"

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
  return contoursAndLines(regions, request, lineSpacing(drops),
                          [pitch = drops.pitch_mm](std::int64_t, double left, double right) {
                            return evenly(left, right, pitch);
                          });
}

}  // namespace lamina
