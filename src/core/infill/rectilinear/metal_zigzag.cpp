// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/metal_zigzag.hpp"

#include <algorithm>
#include <utility>

#include "infill/rectilinear/pass_adaptation.hpp"
#include "infill/rectilinear/raster.hpp"
#include "infill/rectilinear/section_order.hpp"

namespace lamina {
namespace {

BoustrophedonCell endsOf(const GridSection& section) {
  return {{section.passes.front().front(), section.passes.front().back()},
          {section.passes.back().front(), section.passes.back().back()},
          section.passes.size()};
}

/// The section to and fro, from where it is entered.
Polyline deposited(GridSection section, SectionEntry entry) {
  if (static_cast<int>(entry) >= 2) {
    std::reverse(section.passes.begin(), section.passes.end());
    std::swap(section.below, section.above);
  }
  bool goes_left = static_cast<int>(entry) % 2 != 0;
  Polyline points;
  if (section.below) points.push_back(*section.below);
  for (Polyline& pass : section.passes) {
    if (goes_left) std::reverse(pass.begin(), pass.end());
    points.insert(points.end(), pass.begin(), pass.end());
    goes_left = !goes_left;
  }
  if (section.above) points.push_back(*section.above);
  return points;
}

}  // namespace

std::vector<FillPath> metalZigzag(const Regions& perimeters, const InfillRequest& request) {
  const HybridSettings& settings = request.settings.hybrid;
  const RasterFrame frame(request.angle_rad);
  std::vector<FillPath> runs;
  InfillRequest next = request;
  for (const Region& region : perimeters) {
    std::vector<Polygon> perimeter = outlines({region});
    for (Polygon& outline : perimeter)
      for (Point2& point : outline) point = frame.intoRaster(point);
    std::vector<GridSection> grid = gridSections(perimeter, request.spacing_mm,
                                                 frame.intoRaster({settings.grid_x_mm, settings.grid_y_mm}));
    const PerimeterApproach approach(perimeter, request.spacing_mm, settings);
    adaptLongitudinally(grid, approach);
    adaptTransversally(grid, approach);
    std::vector<BoustrophedonCell> sections;
    sections.reserve(grid.size());
    for (const GridSection& section : grid) sections.push_back(endsOf(section));
    for (const SectionVisit& visit :
         tourOf(sections, frame.intoRaster(next.start), request.settings.raster.order)) {
      FillPath run;
      for (const Point2& point : deposited(grid[visit.section], visit.entry))
        run.points.push_back(frame.outOfRaster(point));
      if (run.points.size() < 2) continue;
      next.start = run.points.back();
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

}  // namespace lamina
