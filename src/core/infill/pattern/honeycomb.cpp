// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/pattern/honeycomb.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "infill/pattern/pattern_fill.hpp"
#include "infill/rectilinear/raster.hpp"
#include "infill/rectilinear/zigzag.hpp"

namespace lamina {
namespace {

/// Rows of hexagons of which two edges lie along x.
class HexagonRows {
 public:
  HexagonRows(double flat_to_flat_mm, double pitch_mm)
      : half_(0.5 * flat_to_flat_mm), pitch_(pitch_mm), edge_(flat_to_flat_mm / std::sqrt(3.0)) {}

  /// Rows lie half the distance of parallel walls apart. Row k goes up and down between y = k half and
  /// (k + 1) half, less the half of a bead that is the neighbour's. Even rows are the upper halves of
  /// hexagons round the origin, odd ones the lower halves of those above.
  Polyline row(double number, double from_x, double to_x) const {
    const double low = number * half_ + 0.5 * pitch_;
    const double high = (number + 1.0) * half_ - 0.5 * pitch_;
    const bool is_even = std::fmod(number, 2.0) == 0.0;
    const double at_first = is_even ? low : high;
    const double at_second = is_even ? high : low;
    const double shortened = 0.5 * pitch_ / std::sqrt(3.0);  // along x, of a slanted edge at either end
    Polyline points;
    const double period = 3.0 * edge_;
    for (double x = std::floor(from_x / period - 1.0) * period; x < to_x + period; x += period) {
      points.emplace_back(x - 0.5 * edge_ - shortened, at_first);
      points.emplace_back(x + 0.5 * edge_ + shortened, at_first);
      points.emplace_back(x + edge_ - shortened, at_second);
      points.emplace_back(x + 2.0 * edge_ + shortened, at_second);
    }
    return points;
  }

  double half() const { return half_; }

 private:
  double half_;
  double pitch_;
  double edge_;
};

double flatToFlat(const InfillRequest& request) {
  const double s = request.spacing_mm;
  return (4.0 * s + std::sqrt(std::max(0.0, 16.0 * s * s - 12.0 * request.pitch_mm * s))) / 3.0;
}

}  // namespace

std::vector<FillPath> honeycomb(const Regions& regions, const InfillRequest& request) {
  if (isSolid(request)) return zigzag(regions, request);
  const HexagonRows hexagons(flatToFlat(request), request.pitch_mm);
  return filledByPattern(regions, request, hexagons.half(), [&](const Box2& box) {
    const RasterFrame frame(patternAngle(request));
    const Box2 turned = boxInRaster(box, frame);
    PatternCurves curves;
    const double last = std::ceil(turned.high.y() / hexagons.half());
    for (double row = std::floor(turned.low.y() / hexagons.half()) - 1.0; row <= last; ++row) {
      Polyline points = hexagons.row(row, turned.low.x(), turned.high.x());
      for (Point2& point : points) point = frame.outOfRaster(point);
      curves.open.push_back(std::move(points));
    }
    return curves;
  });
}

}  // namespace lamina
