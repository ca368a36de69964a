// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "slicing/volumetric/growth_lattice.hpp"

namespace lamina {

/// Which part of a surface counts as an overhang.
struct OverhangQuestion {
  double max_overhang_rad = 0.785;
  double above_mm = 0.0;  ///< z up to which the surface rests on the bed
};

/// Area of a part's surface that overhangs.
struct HangingSurface {
  double surface_mm2 = 0.0;
  double level_mm2 = 0.0;  ///< area that overhangs by more than is allowed if layers are level
  double grown_mm2 = 0.0;  ///< area that overhangs by more than is allowed if layers follow the growth
  std::vector<double> grown_by_triangle;  ///< `grown_mm2` of each triangle of the mesh [mm²]
  Mesh grown;                             ///< the triangles, or pieces of triangles, of `grown_mm2`
};

/// Measures overhanging surface by samples at most a cell apart, each with the growth of the layers there.
/// Surface that no growth reaches counts as overhanging.
/// @throws Cancelled
HangingSurface hangingSurface(const Mesh& mesh, const CellGraph& cells, const GrowthLattice& lattice,
                              const OverhangQuestion& question, Progress& progress);

/// Relative thickness of layers, over the nominal height, from the growth of neighbouring cells.
struct GrownThickness {
  double least = 1.0;
  double greatest = 1.0;
  /// Share of the volume in which the thickness lies outside [1, max_thickness] by more than 2 %.
  double beyond = 0.0;
  Point3 farthest = Point3::Zero();  ///< where it is farthest outside, by the ratio to the bound passed
};

/// Thickness of layers by least squares over neighbouring cells. Cells with a neighbour that grows in another
/// direction, where fronts meet, are left out.
/// @param max_thickness  thickness that `beyond` allows, relative to the nominal layer height; at least 1
GrownThickness grownThickness(const CellGraph& cells, const GrowthLattice& lattice, double max_thickness);

/// Number of cells that are reached before all their neighbours, that is, where growth begins in the air.
/// @param bed_mm  z up to which such cells rest on the bed and are not counted
std::size_t growthMinima(const CellGraph& cells, const GrowthLattice& lattice, double bed_mm);

/// Share of a layer that rests on what was deposited before it.
struct RestingShare {
  double area_mm2 = 0.0;
  double resting_mm2 = 0.0;
  double least = 1.0;  ///< least share of all connected pieces
  Point3 least_at = Point3::Zero();
  std::size_t pieces = 0;
};

/// Measures how a layer rests, piece by connected piece. A place rests if the part or the bed lies one layer
/// height below it and at most one layer height to the side.
/// @param carried_mm2  pieces with at most this area that does not rest do not count for the least share
RestingShare restingShare(const LayerSurface& layer, const CellGraph& cells, double bed_mm,
                          double carried_mm2);

}  // namespace lamina
