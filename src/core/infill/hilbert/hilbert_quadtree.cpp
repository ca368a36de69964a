// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/hilbert/hilbert_quadtree.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "infill/hilbert/angle_search.hpp"
#include "infill/lattice/lattice.hpp"
#include "infill/lattice/lattice_tours.hpp"
#include "infill/lattice/lattice_walk.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

FillPath pathOf(const LatticeWalk& walk, const Lattice& lattice, double width_mm) {
  const auto stride = static_cast<std::uint32_t>(lattice.frame.columns());
  FillPath path;
  path.is_closed = walk.is_closed;
  path.points.reserve(walk.cells.size());
  path.width_mm.reserve(walk.cells.size());
  for (std::size_t i = 0; i < walk.cells.size(); ++i) {
    const std::uint32_t cell = walk.cells[i];
    path.points.push_back(
        lattice.frame.centre({static_cast<int>(cell % stride), static_cast<int>(cell / stride)}));
    path.width_mm.push_back(walk.is_doubled[i] ? 0.5 * width_mm : width_mm);
  }
  return path;
}

/// Steps from corner to corner are taken only where the lattice falls apart without.
std::vector<LatticeWalk> fewestWalks(Lattice& lattice) {
  const LatticeTours tours = makeTours(lattice);
  std::vector<LatticeWalk> walks = walkLattice(lattice, tours);
  if (walks.size() < 2) return walks;
  lattice.findDiagonals();
  return walkLattice(lattice, tours);
}

FillAtAngle quadtreeFillAt(const Region& centre_lines, const InfillRequest& request, double angle_rad) {
  Lattice lattice(centre_lines, request.spacing_mm, angle_rad);
  const double width = beadWidth(lattice.frame, request);
  FillAtAngle fill;
  for (const LatticeWalk& walk : fewestWalks(lattice)) {
    fill.covered += static_cast<double>(walk.cells.size());
    fill.paths.push_back(pathOf(walk, lattice, width));
  }
  return fill;
}

/// A line that comes so near to the border's centre line touches what lies round the region, in pitches.
constexpr double kTouching = 0.1;
/// From farther away there are other runs between, in spacings.
constexpr double kLongestAnchor = 1.5;
/// So far an anchor goes on beyond the border's centre line, in pitches: its beads are half as wide.
constexpr double kBeyondBorder = 0.25;

/// The shortest way from a corner of a run to a border.
struct WayToBorder {
  std::size_t corner = 0;
  Point2 border = Point2::Zero();
  double gap_mm = std::numeric_limits<double>::infinity();  ///< as if the bead there had its full width
};

/// Half the full width less half that of the widest bead at a corner [mm].
double shortfall(const FillPath& path, std::size_t corner, double full_mm) {
  const std::size_t next = corner + 1 < path.points.size() ? corner + 1 : 0;
  return 0.5 * (full_mm - std::max(path.width_mm[corner], path.width_mm[next]));
}

/// Ends as soon as a gap is no longer than `enough_mm`.
WayToBorder shortestWay(const FillPath& path, const std::vector<Polygon>& borders, double full_mm,
                        double enough_mm) {
  WayToBorder shortest;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const double less_mm = shortfall(path, i, full_mm);
    for (const Polygon& border : borders)
      for (std::size_t k = 0, before = border.size() - 1; k < border.size(); before = k++) {
        const Point2 there = nearestOnSegment(border[before], border[k], path.points[i]);
        const double gap_mm = (there - path.points[i]).norm() + less_mm;
        if (gap_mm >= shortest.gap_mm) continue;
        shortest = {i, there, gap_mm};
        if (gap_mm <= enough_mm) return shortest;
      }
  }
  return shortest;
}

/// Adds a spur from a corner: out and back, each by half the width; at an open end only out.
void addSpur(FillPath& path, std::size_t corner, const Point2& tip, double full_mm) {
  const auto after = static_cast<std::ptrdiff_t>(corner) + 1;
  const Point2 foot = path.points[corner];
  if (!path.is_closed && corner == 0) {
    path.points.insert(path.points.begin(), tip);
    path.width_mm.insert(path.width_mm.begin(), full_mm);
    path.width_mm[1] = full_mm;
  } else if (!path.is_closed && corner + 1 == path.points.size()) {
    path.points.push_back(tip);
    path.width_mm.push_back(full_mm);
  } else {
    path.points.insert(path.points.begin() + after, {tip, foot});
    path.width_mm.insert(path.width_mm.begin() + after, {0.5 * full_mm, 0.5 * full_mm});
  }
}

/// Sparse runs keep to the middles of cells, wherever those lie: one that touches nothing round its region
/// would hold on to nothing.
void anchorAtBorder(FillPath& path, const std::vector<Polygon>& borders, const InfillRequest& request) {
  const double full_mm =
      std::max(request.pitch_mm, *std::max_element(path.width_mm.begin(), path.width_mm.end()));
  const double touching_mm = kTouching * request.pitch_mm;
  const WayToBorder way = shortestWay(path, borders, full_mm, touching_mm);
  if (way.gap_mm <= touching_mm || way.gap_mm > kLongestAnchor * request.spacing_mm) return;
  const Point2 out = way.border - path.points[way.corner];
  const Point2 beyond = kBeyondBorder * request.pitch_mm * out.normalized();
  addSpur(path, way.corner, way.border + beyond, full_mm);
}

}  // namespace

std::vector<FillPath> hilbertQuadtree(const Regions& regions, const InfillRequest& request) {
  std::vector<FillPath> paths;
  for (const Region& centre_lines : offset(regions, -0.5 * request.pitch_mm)) {
    std::vector<FillPath> runs = fillAtBestAngle({centre_lines}, request, quadtreeFillAt);
    if (!isSolid(request))
      for (FillPath& run : runs) anchorAtBorder(run, outlines({centre_lines}), request);
    std::move(runs.begin(), runs.end(), std::back_inserter(paths));
  }
  return paths;
}

}  // namespace lamina
