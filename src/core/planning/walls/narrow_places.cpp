// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls/narrow_places.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// Thinner places are slivers that rounding leaves, in distances.
constexpr double kSliver = 0.1;
/// Corners may hold so much that is thin, in squared thicknesses.
constexpr double kNarrowCorners = 0.1;

double perimeterOf(const Regions& regions) {
  double sum = 0.0;
  for (const Polygon& outline : outlines(regions)) sum += perimeter(outline);
  return sum;
}

}  // namespace

bool isWideEverywhere(const Regions& whole, const Regions& shrunk, double distance_mm, double tolerance_mm2) {
  // A disc of that radius vanishes without a trace in the areas.
  if (outlines(shrunk).size() != outlines(whole).size()) return false;
  const double taken = area(whole) - area(shrunk);
  const double alongside = 0.5 * distance_mm * (perimeterOf(whole) + perimeterOf(shrunk));
  return std::abs(taken - alongside) < tolerance_mm2;
}

SplitArea splitByThickness(const Regions& whole, const Regions& shrunk, double distance_mm,
                           double least_mm2) {
  SplitArea split;
  split.wide = intersection(offset(shrunk, distance_mm), whole);
  const double sliver = kSliver * distance_mm;
  split.narrow = offset(offset(difference(whole, split.wide), -sliver), sliver);
  split.narrow.erase(std::remove_if(split.narrow.begin(), split.narrow.end(),
                                    [&](const Region& region) { return area({region}) < least_mm2; }),
                     split.narrow.end());
  return split;
}

double areaThinnerThan(const Regions& material, double thickness_mm) {
  const double distance = 0.5 * thickness_mm;
  const Regions shrunk = offset(material, -distance);
  const double tolerance = kNarrowCorners * thickness_mm * thickness_mm;
  if (isWideEverywhere(material, shrunk, distance, tolerance)) return 0.0;
  const double thin = area(difference(material, offset(shrunk, distance)));
  return thin > tolerance ? thin : 0.0;
}

}  // namespace lamina
