// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/perimeters.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "infill/contour/contour_tree.hpp"
#include "infill/contour/loop_seam.hpp"
#include "infill/contour/normal_loop.hpp"
#include "infill/variable_width/medial_beads.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// So much of a bead must have room on the inner side of its centre line, in pitches: nearly all of it.
constexpr double kLeastRoom = 0.45;
/// Smaller rests are not worth a bead, in squared pitches.
constexpr double kLeastArea = 0.2;
/// Shorter loops are points, in pitches.
constexpr double kShortestPerimeter = 1.0;

/// Loops and beads with the same number of perimeters outside.
struct Level {
  std::vector<Polygon> loops;
  std::vector<FillPath> beads;
};

Regions grown(const Regions& regions, double delta) {
  return delta == 0.0 ? regions : offset(regions, delta);
}

/// As many as fit, and beads where the rest is narrow.
std::vector<Level> fittedLevels(const Region& region, const InfillRequest& request) {
  MedialBeadSettings settings;
  settings.pitch_mm = request.pitch_mm;
  const OpenContourTree open = openContourTree(region, request);
  std::vector<std::size_t> depth(open.tree.parents.size(), 0);
  for (std::size_t node = 1; node < depth.size(); ++node) depth[node] = depth[open.tree.parents[node]] + 1;
  std::vector<Level> levels(1 + *std::max_element(depth.begin(), depth.end()));
  for (const ContourLoop& loop : open.tree.loops) levels[depth[loop.node] - 1].loops.push_back(loop.points);
  for (const NarrowRest& rest : open.rests) {
    if (area({rest.area}) < kLeastArea * request.pitch_mm * request.pitch_mm) continue;
    std::vector<FillPath>& beads = levels[depth[rest.parent]].beads;
    for (FillPath& bead : medialBeads({rest.area}, settings)) beads.push_back(std::move(bead));
  }
  return levels;
}

std::vector<Level> robustLevels(Regions centre_lines, std::size_t most, const InfillRequest& request) {
  const double room = kLeastRoom * request.pitch_mm;
  std::vector<Level> levels;
  while (levels.size() < most && !centre_lines.empty()) {
    levels.push_back({outlines(offset(offset(centre_lines, -room), room)), {}});
    centre_lines = offset(centre_lines, -request.spacing_mm);
  }
  return levels;
}

std::vector<Level> documentedLevels(const Regions& centre_lines, std::size_t most,
                                    const InfillRequest& request) {
  std::vector<NormalLoop> outermost;
  for (const Polygon& outline : outlines(centre_lines))
    outermost.push_back(withNormals(outline, request.spacing_mm));
  std::vector<Level> levels;
  for (Regions left = centre_lines; levels.size() < most && !left.empty();
       left = offset(left, -request.spacing_mm)) {
    const double inset = static_cast<double>(levels.size()) * request.spacing_mm;
    levels.emplace_back();
    for (const NormalLoop& loop : outermost) levels.back().loops.push_back(movedInwards(loop, inset));
  }
  return levels;
}

/// The levels of both, side by side.
void merge(std::vector<Level>& levels, std::vector<Level> more) {
  levels.resize(std::max(levels.size(), more.size()));
  for (std::size_t k = 0; k < more.size(); ++k) {
    std::move(more[k].loops.begin(), more[k].loops.end(), std::back_inserter(levels[k].loops));
    std::move(more[k].beads.begin(), more[k].beads.end(), std::back_inserter(levels[k].beads));
  }
}

std::vector<Level> levelsOf(const Region& region, const InfillRequest& request) {
  const PerimetersSettings& settings = request.settings.perimeters;
  const double inset = settings.first_inset * request.pitch_mm;
  const std::size_t most =
      settings.count > 0 ? static_cast<std::size_t>(settings.count) : std::numeric_limits<std::size_t>::max();
  if (settings.offset == PerimeterOffset::Normals)
    return documentedLevels(grown({region}, -inset), most, request);
  if (settings.count > 0) return robustLevels(grown({region}, -inset), most, request);
  std::vector<Level> levels;
  for (const Region& area : grown({region}, 0.5 * request.pitch_mm - inset))
    merge(levels, fittedLevels(area, request));
  return levels;
}

bool isInsideOut(const InfillRequest& request) {
  const PerimeterOrder order = request.settings.perimeters.order;
  return order == PerimeterOrder::InsideOut ||
         (order == PerimeterOrder::Alternating && request.layer % 2 != 0);
}

/// Moves runs to the end of others, always the one that begins nearest to where the last one ended.
void appendByDistance(std::vector<FillPath> runs, const Point2& start, std::vector<FillPath>& deposited) {
  while (!runs.empty()) {
    const Point2 from = deposited.empty() ? start : lastPoint(deposited.back());
    const auto nearest =
        std::min_element(runs.begin(), runs.end(), [&](const FillPath& a, const FillPath& b) {
          return (a.points.front() - from).squaredNorm() < (b.points.front() - from).squaredNorm();
        });
    deposited.push_back(std::move(*nearest));
    runs.erase(nearest);
  }
}

std::vector<FillPath> runsOf(Level level, std::size_t k, const InfillRequest& request, LoopSeam& seam) {
  std::vector<FillPath> runs = std::move(level.beads);
  for (const Polygon& loop : level.loops) {
    if (loop.size() < 3 || perimeter(loop) < kShortestPerimeter * request.pitch_mm) continue;
    FillPath run =
        openedLoop(loop, seam.startOn(loop, k), request.settings.perimeters.end_gap * request.pitch_mm);
    run.role = k == 0 ? PathRole::OuterWall : PathRole::InnerWall;
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace

std::vector<FillPath> perimeters(const Regions& regions, const InfillRequest& request) {
  LoopSeam seam(request);
  std::vector<FillPath> deposited;
  for (const Region& region : regions) {
    requireContourSpacing(region, request.spacing_mm);
    std::vector<std::vector<FillPath>> runs;
    for (Level& level : levelsOf(region, request))
      runs.push_back(runsOf(std::move(level), runs.size(), request, seam));
    if (isInsideOut(request)) std::reverse(runs.begin(), runs.end());
    for (std::vector<FillPath>& of_level : runs)
      appendByDistance(std::move(of_level), request.start, deposited);
  }
  return deposited;
}

}  // namespace lamina
