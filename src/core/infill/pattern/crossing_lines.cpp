// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/pattern/crossing_lines.hpp"

#include <cmath>

#include "infill/pattern/pattern_fill.hpp"
#include "infill/rectilinear/raster.hpp"
#include "infill/rectilinear/zigzag.hpp"

namespace lamina {
namespace {

/// Parallel lines; one at that distance from the origin.
struct ParallelLines {
  double angle_rad = 0.0;
  double step_mm = 1.0;
  double shift_mm = 0.0;  ///< to the left of the direction
};

void addLines(const ParallelLines& lines, const Box2& box, std::vector<Polyline>& all) {
  const RasterFrame frame(lines.angle_rad, std::fmod(lines.shift_mm, lines.step_mm));
  const Box2 turned = boxInRaster(box, frame);
  const double beyond = lines.step_mm;
  const double last = std::floor(turned.high.y() / lines.step_mm);
  for (double line = std::ceil(turned.low.y() / lines.step_mm); line <= last; ++line) {
    const double y = line * lines.step_mm;
    all.push_back(
        {frame.outOfRaster({turned.low.x() - beyond, y}), frame.outOfRaster({turned.high.x() + beyond, y})});
  }
}

std::vector<FillPath> crossingLines(const Regions& regions, const InfillRequest& request,
                                    const std::vector<double>& directions_rad, double shift_mm) {
  if (isSolid(request)) return zigzag(regions, request);
  const double step = static_cast<double>(directions_rad.size()) * request.spacing_mm;
  return filledByPattern(regions, request, step, [&](const Box2& box) {
    PatternCurves curves;
    for (const double direction : directions_rad)
      addLines({patternAngle(request) + direction, step, shift_mm}, box, curves.open);
    return curves;
  });
}

constexpr double kThirdOfTurn = 2.0 * M_PI / 3.0;

}  // namespace

std::vector<FillPath> gridFill(const Regions& regions, const InfillRequest& request) {
  return crossingLines(regions, request, {0.0, 0.5 * M_PI}, 0.0);
}

std::vector<FillPath> trianglesFill(const Regions& regions, const InfillRequest& request) {
  return crossingLines(regions, request, {0.0, kThirdOfTurn, 2.0 * kThirdOfTurn}, 0.0);
}

std::vector<FillPath> cubicFill(const Regions& regions, const InfillRequest& request) {
  // Planes at right angles to each other, evenly about z, rise by sqrt 2 over their distance in the plane.
  return crossingLines(regions, request, {0.0, kThirdOfTurn, 2.0 * kThirdOfTurn},
                       heightOf(request) * M_SQRT1_2);
}

}  // namespace lamina
