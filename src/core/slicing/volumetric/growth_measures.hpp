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

/// Which overhangs are looked at.
struct OverhangQuestion {
  double max_overhang_rad = 0.785;
  double above_mm = 0.0;  ///< z, below which the surface rests on the bed
};

/// What of a part's surface hangs.
struct HangingSurface {
  double surface_mm2 = 0.0;
  double level_mm2 = 0.0;                 ///< overhangs by more than is taken, over level layers
  double grown_mm2 = 0.0;                 ///< over the layers of the growth
  std::vector<double> grown_by_triangle;  ///< the same of each triangle [mm²]
  Mesh grown;                             ///< the same as pieces of triangles
};

/// By samples of the surface at most a cell apart, each with the growth that the layers have there. What no
/// growth leads to hangs.
/// @throws Cancelled
HangingSurface hangingSurface(const Mesh& mesh, const CellGraph& cells, const GrowthLattice& lattice,
                              const OverhangQuestion& question, Progress& progress);

/// Thickness of layers as the growth of neighbouring cells gives it, over the nominal height.
struct GrownThickness {
  double least = 1.0;
  double greatest = 1.0;
  double beyond = 0.0;  ///< share of the volume outside of [1, max_thickness] by more than 2 %
};

/// By least squares over neighbours. Cells one of whose neighbours grows another way are where fronts meet:
/// they are left out.
GrownThickness grownThickness(const CellGraph& cells, const GrowthLattice& lattice, double max_thickness);

/// Cells that are reached before all their neighbours.
/// @param bed_mm  what stands below this z is not counted
std::size_t growthMinima(const CellGraph& cells, const GrowthLattice& lattice, double bed_mm);

/// How layers lie on what is deposited before them.
struct RestingShare {
  double area_mm2 = 0.0;
  double resting_mm2 = 0.0;
  double least = 1.0;  ///< share of the piece with least
  Point3 least_at = Point3::Zero();
  std::size_t pieces = 0;
};

/// Of the connected pieces of a layer. A place rests if one height below it there is
/// part, no farther aside than that height, or the bed.
/// @param carried_mm2  pieces of which no more than that does not rest are not looked for the least share
RestingShare restingShare(const LayerSurface& layer, const CellGraph& cells, double bed_mm,
                          double carried_mm2);

}  // namespace lamina
