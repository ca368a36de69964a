// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/medial/narrow_loops.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "infill/contour/straightened.hpp"
#include "infill/medial/axis_loops.hpp"
#include "infill/medial/axis_steps.hpp"
#include "infill/medial/bead_axis.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// Thickness below which nothing is deposited, in pitches.
constexpr double kLeastWidth = 0.3;
/// So far the border may be straightened before its axis is sought, in pitches.
constexpr double kStraight = 0.02;
/// By how much the radius may change within one motion, in pitches.
constexpr double kWidthStep = 0.05;
/// Smaller regions are left out, in squared pitches.
constexpr double kLeastArea = 0.2;
/// Shorter loops are left out, in pitches.
constexpr double kShortest = 1.0;
/// Of regions that are filled along their border, in pitches: the corners of thinner ones are in the way of
/// links.
constexpr double kLeastRadius = 0.6;
/// How much of a region's area a loop along its border may lay.
constexpr double kMostFilled = 1.06;

double largestRadius(const MedialAxis& axis) {
  double largest = 0.0;
  for (const AxisBranch& branch : axis.branches)
    for (const AxisPoint& point : branch.points) largest = std::max(largest, point.radius_mm);
  return largest;
}

/// One loop along the border, half as wide as the largest disc inside: it reaches everything. None if it
/// would lay too much, because the region is narrower elsewhere.
std::optional<ContourLoop> borderLoop(const Region& region, double radius) {
  const Regions centre_lines = offset({region}, -0.5 * radius);
  if (centre_lines.size() != 1 || !centre_lines.front().holes.empty()) return std::nullopt;
  ContourLoop loop;
  loop.points = centre_lines.front().outer;
  if (perimeter(loop.points) * radius > kMostFilled * area({region})) return std::nullopt;
  loop.width_mm.assign(loop.points.size(), radius);
  return loop;
}

}  // namespace

std::vector<ContourLoop> narrowLoops(const Region& region, double pitch_mm) {
  if (area({region}) < kLeastArea * pitch_mm * pitch_mm) return {};
  MedialBeadSettings settings;
  settings.pitch_mm = pitch_mm;
  settings.least_width = kLeastWidth;
  MedialAxis axis = beadAxis(straightened(region, kStraight * pitch_mm), settings);
  const double radius = largestRadius(axis);
  if (radius > kLeastRadius * pitch_mm)
    if (std::optional<ContourLoop> loop = borderLoop(region, radius)) return {std::move(*loop)};
  for (AxisBranch& branch : axis.branches)
    branch.points = inRadiusSteps(branch.points, kWidthStep * pitch_mm);
  std::vector<ContourLoop> loops;
  for (FillPath& path : axisLoops(axis, region)) {
    if (perimeter(path.points) < kShortest * pitch_mm) continue;
    ContourLoop loop;
    loop.points = std::move(path.points);
    loop.width_mm = std::move(path.width_mm);
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace lamina
