// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/plate_overlap.hpp"

#include <algorithm>
#include <cstdio>

#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"

namespace lamina {
namespace {

constexpr double kTouchingArea = 1e-3;  // mm²: what the grid of polygons leaves of parts that touch
constexpr double kOnEdge = 1e-6;        // mm

bool meet(const Box3& a, const Box3& b) {
  return (a.low.array() < b.high.array()).all() && (b.low.array() < a.high.array()).all();
}

std::vector<Regions> sectionsOf(const StandingPart& part, const std::vector<double>& heights,
                                Progress& progress) {
  std::vector<Regions> regions;
  for (Section& section : sliceMesh(*part.mesh, heights, progress)) {
    for (Polygon& contour : section.contours)
      for (Point2& point : contour) point += part.at;
    regions.push_back(unite(section.contours));
  }
  return regions;
}

void requireApart(const StandingPart& a, const StandingPart& b, double step_mm, Progress& progress) {
  const Box3 box_a = a.boxOnBed();
  const Box3 box_b = b.boxOnBed();
  if (!meet(box_a, box_b)) return;
  const double top = std::min(box_a.high.z(), box_b.high.z());
  std::vector<double> heights;
  for (double z = std::min(0.5 * step_mm, 0.5 * top); z < top; z += step_mm) heights.push_back(z);
  const std::vector<Regions> of_a = sectionsOf(a, heights, progress);
  const std::vector<Regions> of_b = sectionsOf(b, heights, progress);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const Regions common = intersection(of_a[i], of_b[i]);
    const double common_mm2 = area(common);
    if (common_mm2 <= kTouchingArea) continue;
    const Point2 place = boundingBox(outlines(common)).centre();
    char text[192];
    std::snprintf(
        text, sizeof text,
        "' overlap by %.4g mm2 at z %.4g mm, about (%.2f, %.2f) mm of the bed; expected parts that are apart",
        common_mm2, heights[i], place.x(), place.y());
    throw InvalidInput("parts '" + a.name + "' and '" + b.name + text);
  }
}

}  // namespace

Box3 StandingPart::boxOnBed() const {
  const Point3 shift(at.x(), at.y(), 0.0);
  return {box.low + shift, box.high + shift};
}

void requireNoOverlap(const std::vector<StandingPart>& parts, double step_mm, Progress& progress) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t k = i + 1; k < parts.size(); ++k) requireApart(parts[i], parts[k], step_mm, progress);
}

void requireOnBed(const std::vector<StandingPart>& parts, const Box3& space, const std::string& machine) {
  constexpr const char* kAxes = "xyz";
  for (const StandingPart& part : parts) {
    const Box3 box = part.boxOnBed();
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_high = box.high[axis] > space.high[axis] + kOnEdge;
      if (!is_high && (axis == 2 || box.low[axis] >= space.low[axis] - kOnEdge)) continue;
      char text[192];
      std::snprintf(text, sizeof text,
                    "' reaches to %c %.4g mm; the machine %s reaches over %.4g to %.4g mm there", kAxes[axis],
                    is_high ? box.high[axis] : box.low[axis], machine.c_str(), space.low[axis],
                    space.high[axis]);
      throw Unreachable("part '" + part.name + text);
    }
  }
}

}  // namespace lamina
