// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/hybrid.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "infill/contour/perimeter.hpp"
#include "infill/rectilinear/metal_zigzag.hpp"
#include "infill/rectilinear/raster_direction.hpp"
#include "infill/rectilinear/section_order.hpp"
#include "infill/rectilinear/variable_width_runs.hpp"
#include "infill/rectilinear/zigzag.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

int perimeterCount(const InfillRequest& request) {
  const int every = request.settings.hybrid.extra_perimeter_every;
  return every > 0 && (request.layer + 1) % static_cast<std::size_t>(every) == 0 ? 2 : 1;
}

/// Perimeters and zigzag as in [Flores2018, section 6.1.2].
std::vector<FillPath> documentedHybrid(const Regions& regions, const InfillRequest& request) {
  std::vector<FillPath> runs;
  Regions centre_lines = offset(regions, -0.5 * request.pitch_mm);
  for (int k = perimeterCount(request); k > 0; --k) {
    for (Polygon& loop : outlines(centre_lines))
      runs.push_back({std::move(loop), true, PathRole::OuterWall, Deposit::Bead, {}});
    if (k > 1) centre_lines = offset(centre_lines, -request.pitch_mm);
  }
  InfillRequest inside = request;
  if (!runs.empty()) inside.start = lastPoint(runs.back());
  for (FillPath& run : metalZigzag(centre_lines, inside)) runs.push_back(std::move(run));
  return runs;
}

/// The perimeters, and what follows them, beads of narrow places and zigzags together, in an order of short
/// travels.
std::vector<FillPath> orderedInside(std::vector<FillPath> runs, const Point2& start) {
  const auto inside = std::find_if(runs.begin(), runs.end(),
                                   [](const FillPath& run) { return run.role != PathRole::OuterWall; });
  std::vector<BoustrophedonCell> sections;
  for (auto run = inside; run != runs.end(); ++run) {
    const std::array<Point2, 2> ends = {run->points.front(), lastPoint(*run)};
    sections.push_back({ends, ends, 1});
  }
  const Point2 from = inside == runs.begin() ? start : lastPoint(*(inside - 1));
  std::vector<FillPath> ordered;
  for (const SectionVisit& visit : improvedTour(sections, from)) {
    FillPath& run = *(inside + static_cast<std::ptrdiff_t>(visit.section));
    const bool is_backwards = static_cast<int>(visit.entry) % 2 != 0;
    ordered.push_back(is_backwards ? reversed(std::move(run)) : std::move(run));
  }
  std::move(ordered.begin(), ordered.end(), inside);
  return runs;
}

}  // namespace

std::vector<FillPath> hybrid(const Regions& regions, const InfillRequest& request) {
  if (request.settings.hybrid.lines == HybridLines::Documented) return documentedHybrid(regions, request);
  PerimeterFill fill = layPerimeters(regions, perimeterCount(request), request);
  InfillRequest inside = request;
  if (!fill.runs.empty()) inside.start = lastPoint(fill.runs.back());
  const std::vector<FillPath> zigzags =
      isSolid(request)
          ? inBestDirection(fill.links, inside, variableWidthRuns)
          : inBestDirection(offset(fill.links, -0.5 * (request.pitch_mm - narrowestBead(request))), inside,
                            rasterRuns);
  for (const FillPath& run : zigzags) fill.runs.push_back(run);
  if (request.settings.raster.order == SectionOrder::Optimised)
    return orderedInside(std::move(fill.runs), request.start);
  return std::move(fill.runs);
}

}  // namespace lamina
