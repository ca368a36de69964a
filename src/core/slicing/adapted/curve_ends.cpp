// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/curve_ends.hpp"

#include <algorithm>
#include <cstddef>

namespace lamina {
namespace {

void appendBetween(AdaptedCurve& cut, const AdaptedCurve& curve, std::size_t i, double fraction) {
  const double rest = 1.0 - fraction;
  cut.points.push_back(rest * curve.points[i] + fraction * curve.points[i + 1]);
  cut.axis.push_back((rest * curve.axis[i] + fraction * curve.axis[i + 1]).normalized());
  cut.height_mm.push_back(rest * curve.height_mm[i] + fraction * curve.height_mm[i + 1]);
}

/// Where between point i and the one after it the curve is as high.
double fractionAt(const AdaptedCurve& curve, std::size_t i, double height_mm) {
  return (height_mm - curve.height_mm[i]) / (curve.height_mm[i + 1] - curve.height_mm[i]);
}

}  // namespace

AdaptedCurve withoutThinEnds(const AdaptedCurve& curve, double least_mm) {
  if (curve.is_closed) return curve;
  const auto isHigh = [least_mm](double height_mm) { return height_mm >= least_mm; };
  const std::vector<double>& heights = curve.height_mm;
  const auto first =
      static_cast<std::size_t>(std::find_if(heights.begin(), heights.end(), isHigh) - heights.begin());
  AdaptedCurve cut;
  cut.is_closed = false;
  if (first == heights.size()) return cut;
  const auto end =
      static_cast<std::size_t>(heights.rend() - std::find_if(heights.rbegin(), heights.rend(), isHigh));
  if (first > 0) appendBetween(cut, curve, first - 1, fractionAt(curve, first - 1, least_mm));
  for (std::size_t i = first; i < end; ++i) {
    cut.points.push_back(curve.points[i]);
    cut.axis.push_back(curve.axis[i]);
    cut.height_mm.push_back(heights[i]);
  }
  if (end < heights.size()) appendBetween(cut, curve, end - 1, fractionAt(curve, end - 1, least_mm));
  return cut;
}

}  // namespace lamina
