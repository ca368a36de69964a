// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether volumetric slicing takes the same time for each cell, however many there are.
//
//     lamina_bench_growth_cells
//
// A frustum that opens by 60 deg from upright grows in cells of 0.8, 0.4 and 0.8 / 3 mm, each with layers as
// high as its cells, on one thread. For each the processor time of the field (cells, arrival, lattice) and of
// the extraction (layers cut and trimmed), the less of two runs, by nodes; and these against the first.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/spatial/signed_distance.hpp"
#include "lamina/slicing/planar/layer_stack.hpp"
#include "slicing/volumetric/arrival_field.hpp"
#include "slicing/volumetric/growth_lattice.hpp"
#include "slicing/volumetric/growth_surfaces.hpp"
#include "support/grown_parts.hpp"

namespace {

using namespace lamina;

constexpr double kCell = 0.8;  // mm, the largest
constexpr int kRuns = 2;

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Cost {
  std::size_t nodes = 0;
  std::size_t triangles = 0;
  double field_s = std::numeric_limits<double>::infinity();
  double layers_s = std::numeric_limits<double>::infinity();
};

Cost costOf(const Mesh& part, double cell_mm) {
  NoProgress progress;
  const GrowthGauge gauge({toRadians(25.0), 2.0, toRadians(80.0)});
  const SignedDistance skin(part);
  SlicingSettings slicing;
  slicing.layer_height_mm = cell_mm;
  slicing.first_layer_height_mm = cell_mm;
  Cost cost;
  for (int run = 0; run < kRuns; ++run) {
    const double begin = seconds();
    const CellGraph cells(part, cell_mm, 0.0, progress);
    const ArrivalField field = arrivalField(cells, gauge, {0.0, 0.5 * cell_mm}, progress);
    const GrowthLattice lattice(cells, field, gauge, progress);
    const double grown = seconds();
    double most = 0.0;
    for (const double growth : field.growth_mm)
      if (growth < std::numeric_limits<double>::infinity()) most = std::max(most, growth);
    const std::vector<LayerBounds> bounds = stackLayers(0.0, most + cell_mm, slicing);
    const std::vector<char> is_left(bounds.size(), 0);
    const std::vector<LayerSurface> surfaces =
        growthSurfaces(lattice, cells, {bounds, is_left}, skin, progress);
    cost.layers_s = std::min(cost.layers_s, seconds() - grown);
    cost.field_s = std::min(cost.field_s, grown - begin);
    cost.nodes = cells.nodeCount();
    cost.triangles = 0;
    for (const LayerSurface& surface : surfaces) cost.triangles += surface.middle.triangles.size();
  }
  return cost;
}

}  // namespace

int main() {
  const ThreadLimit one_thread(1);
  const Mesh part = test::openingFrustum(60.0, 8.0);
  std::printf("| cell [mm] | nodes | triangles | field [us a node] | ratio | layers [us a node] | ratio |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  double first_field = 0.0;
  double first_layers = 0.0;
  for (const double divided : {1.0, 2.0, 3.0}) {
    const Cost cost = costOf(part, kCell / divided);
    const double field = 1e6 * cost.field_s / static_cast<double>(cost.nodes);
    const double layers = 1e6 * cost.layers_s / static_cast<double>(cost.nodes);
    if (divided == 1.0) {
      first_field = field;
      first_layers = layers;
    }
    std::printf("| %.3f | %zu | %zu | %.2f | %.2f | %.2f | %.2f |\n", kCell / divided, cost.nodes,
                cost.triangles, field, field / first_field, layers, layers / first_layers);
  }
  return 0;
}
