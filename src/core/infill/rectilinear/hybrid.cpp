// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/hybrid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "infill/least_gap.hpp"
#include "infill/rectilinear/pass_adaptation.hpp"
#include "infill/rectilinear/raster.hpp"
#include "infill/rectilinear/raster_direction.hpp"
#include "infill/rectilinear/section_order.hpp"
#include "infill/rectilinear/variable_width_runs.hpp"
#include "infill/rectilinear/zigzag.hpp"
#include "infill/variable_width/medial_beads.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {
namespace {

/// What perimeters leave of an area, and what they leave it to.
struct PerimeterFill {
  std::vector<FillPath> runs;  ///< closed perimeters, and beads where the area is too narrow for them
  Regions
      links;  ///< the area inside, shrunk by half the narrowest bead of a solid raster (`variableWidthRuns`)
};

/// An area is taken for wide enough if so much of it at most is not, in squared pitches.
constexpr double kNegligible = 0.1;
/// Half of the thickness of gaps that beads reach over anyway, in pitches.
constexpr double kThinnestGap = 0.1;

double beadAlong(const Regions& regions) {
  double sum = 0.0;
  for (const Region& region : regions) {
    sum += perimeter(region.outer);
    for (const Polygon& hole : region.holes) sum += perimeter(hole);
  }
  return sum;
}

/// Whether shrinking took the same from the area everywhere along its border.
bool isWideEverywhere(const Regions& whole, const Regions& shrunk, double distance, double pitch) {
  const double taken = area(whole) - area(shrunk);
  const double alongside = 0.5 * distance * (beadAlong(whole) + beadAlong(shrunk));
  return std::abs(taken - alongside) < kNegligible * pitch * pitch;
}

void addLoops(std::vector<FillPath>& runs, const Regions& centre_lines) {
  for (Polygon& loop : outlines(centre_lines))
    runs.push_back({std::move(loop), true, PathRole::OuterWall, Deposit::Bead, {}});
}

/// Without slivers, and without gaps that are too small.
Regions worthFilling(const Regions& leftover, double pitch) {
  Regions gaps = offset(offset(leftover, -kThinnestGap * pitch), kThinnestGap * pitch);
  gaps.erase(std::remove_if(gaps.begin(), gaps.end(),
                            [&](const Region& gap) { return area({gap}) < kLeastGap * pitch * pitch; }),
             gaps.end());
  return gaps;
}

/// Perimeters side by side from the border of an area inwards. Where it is too narrow for them, and for a
/// narrowest bead between them, beads along its medial axis fill it instead, joined to a perimeter where they
/// end beside it.
PerimeterFill layPerimeters(const Regions& whole, int count, const InfillRequest& request) {
  const double pitch = request.pitch_mm;
  const double depth = count * pitch + 0.5 * narrowestBead(request);
  PerimeterFill fill;
  fill.links = offset(whole, -depth);
  const bool is_wide = isWideEverywhere(whole, fill.links, depth, pitch);
  for (int k = 0; k < count; ++k) {
    const double inset = (k + 0.5) * pitch;
    addLoops(fill.runs, is_wide ? offset(whole, -inset) : offset(fill.links, depth - inset));
  }
  if (is_wide) return fill;
  MedialBeadSettings beads;
  beads.pitch_mm = pitch;
  const Regions gaps = worthFilling(difference(whole, offset(fill.links, depth)), pitch);
  for (FillPath& bead : medialBeads(gaps, beads)) fill.runs.push_back(std::move(bead));
  return fill;
}

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

/// The zigzag of metal deposition inside perimeters as in [Flores2018, section 6.1.2]: gridSections, adapted
/// longitudinally and transversally; ordered by `raster.order`.
///
/// @param perimeters  areas bounded by the centre lines of perimeters
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

int perimeterCount(const InfillRequest& request) {
  const int every = request.settings.hybrid.extra_perimeter_every;
  return every > 0 && (request.layer + 1) % static_cast<std::size_t>(every) == 0 ? 2 : 1;
}

/// Perimeters and zigzag as in [Flores2018, section 6.1.2].
std::vector<FillPath> metalHybrid(const Regions& regions, const InfillRequest& request) {
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
  if (request.settings.hybrid.lines == HybridLines::Metal) return metalHybrid(regions, request);
  PerimeterFill fill = layPerimeters(regions, perimeterCount(request), request);
  InfillRequest inside = request;
  if (!fill.runs.empty()) inside.start = lastPoint(fill.runs.back());
  const std::vector<FillPath> zigzags =
      isSolid(request)
          ? inBestDirection(fill.links, inside, variableWidthRunsWithJogs)
          : inBestDirection(offset(fill.links, -0.5 * (request.pitch_mm - narrowestBead(request))), inside,
                            rasterRuns);
  for (const FillPath& run : zigzags) fill.runs.push_back(run);
  if (request.settings.raster.order == SectionOrder::Optimised)
    return orderedInside(std::move(fill.runs), request.start);
  return std::move(fill.runs);
}

}  // namespace lamina
