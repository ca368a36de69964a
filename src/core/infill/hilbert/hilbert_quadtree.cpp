// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/hilbert/hilbert_quadtree.hpp"

#include <utility>

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

}  // namespace

std::vector<FillPath> hilbertQuadtree(const Regions& regions, const InfillRequest& request) {
  return fillAtBestAngle(offset(regions, -0.5 * request.pitch_mm), request, quadtreeFillAt);
}

}  // namespace lamina
