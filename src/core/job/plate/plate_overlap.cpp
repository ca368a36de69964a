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

/// What stands and lies on the bed, for a part and for its brim or raft.
struct OnBed {
  Regions part;
  Regions beside;
};

OnBed onBed(const StandingPart& part, double cut_mm, Progress& progress) {
  OnBed on_bed{sectionsOf(part, {cut_mm}, progress).front(), part.beside};
  for (Region& region : on_bed.beside) {
    for (Point2& point : region.outer) point += part.at;
    for (Polygon& hole : region.holes)
      for (Point2& point : hole) point += part.at;
  }
  return on_bed;
}

void requireNoneBesideOverlaps(const StandingPart& a, const StandingPart& b, double cut_mm,
                               Progress& progress) {
  if (a.beside.empty() && b.beside.empty()) return;
  const Box3 box_a = a.boxBesides();
  const Box3 box_b = b.boxBesides();
  if (!meet(box_a, box_b)) return;
  const OnBed on_bed_a = onBed(a, cut_mm, progress);
  const OnBed on_bed_b = onBed(b, cut_mm, progress);
  double common_mm2 = 0.0;
  Point2 place = Point2::Zero();
  const auto add = [&](const Regions& of_a, const Regions& of_b) {
    const Regions common = intersection(of_a, of_b);
    if (!common.empty()) place = boundingBox(outlines(common)).centre();
    common_mm2 += area(common);
  };
  add(on_bed_a.beside, on_bed_b.beside);
  add(on_bed_a.part, on_bed_b.beside);
  add(on_bed_a.beside, on_bed_b.part);
  if (common_mm2 <= kTouchingArea) return;
  char text[256];
  std::snprintf(
      text, sizeof text,
      "' overlap by %.4g mm2 with brim or raft, about (%.2f, %.2f) mm of the bed; expected parts that "
      "are farther apart, or narrower brims and rafts",
      common_mm2, place.x(), place.y());
  throw InvalidInput("parts '" + a.name + "' and '" + b.name + text);
}

}  // namespace

Box3 StandingPart::boxBesides() const {
  Box3 whole = boxOnBed();
  for (const Region& region : beside)
    for (const Point2& point : region.outer) {
      const Point2 on_bed = point + at;
      whole.include({on_bed.x(), on_bed.y(), whole.low.z()});
    }
  return whole;
}

Box3 StandingPart::boxOnBed() const {
  const Point3 shift(at.x(), at.y(), 0.0);
  return {box.low + shift, box.high + shift};
}

void requireNoOverlap(const std::vector<StandingPart>& parts, double step_mm, Progress& progress) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t k = i + 1; k < parts.size(); ++k) requireApart(parts[i], parts[k], step_mm, progress);
}

void requireNoneBesideOverlaps(const std::vector<StandingPart>& parts, double first_layer_mm,
                               Progress& progress) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t k = i + 1; k < parts.size(); ++k)
      requireNoneBesideOverlaps(parts[i], parts[k], 0.5 * first_layer_mm, progress);
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
