// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/base/progress.hpp"
#include "slicing/volumetric/cell_graph.hpp"
#include "slicing/volumetric/growth_gauge.hpp"

namespace lamina {

/// Where a part stands.
struct GrowthBed {
  double level_mm = 0.0;    ///< z of the bed
  double contact_mm = 0.1;  ///< above it: what is solid there stands on the bed
};

/// Growth at a place, and its gradient: across the layers, against the tool axis; its length is 1 / relative
/// thickness.
struct GrowthAt {
  double growth_mm = 0.0;
  Point3 gradient = Point3::UnitZ();
};

/// Growth that is above the height over the bed by less than this counts as level, in cells: bits are steps.
constexpr double kLevelCells = 0.01;

/// When growth reaches the nodes of a part: how much nominal layer height has been deposited by then. At each
/// node the least of all ways through the part from the bed, each as long as `GrowthGauge` says.
struct ArrivalField {
  std::vector<double> growth_mm;  ///< at the middles of the nodes; infinite where no way leads
  std::vector<Point3> turn;       ///< where the straight end of the way to the node begins
  std::vector<double> turn_mm;    ///< growth there
  std::vector<char> is_level;     ///< growth is the height over the bed
  /// Gradient at the middle of each node, of a field that was fitted (`fittedGrowth`); empty for one of ways.
  std::vector<Point3> fitted_gradient;
  std::size_t stands = 0;    ///< nodes that stand on the bed
  double contact_mm2 = 0.0;  ///< of the part with the bed
  double bed_mm = 0.0;       ///< z

  /// As the way to a node goes on to a place near it, which may lie beside the part.
  GrowthAt near(const Point3& place, std::uint32_t node, const Point3& middle,
                const GrowthGauge& gauge) const;
};

/// Grows a part from the bed, node by node in the order of arrival. A way to a node is straight as far as it
/// stays in the part, and turns where it must: at the bits of a node from which the next is seen. So the
/// field is exact, but for the bits, where the bed is seen from everywhere, and level to 1e-9 mm where a way
/// that leans no more than the overhang leads up from it. About 1 % of a cell above level counts as level.
///
/// Each node is settled once; cost grows with the nodes, by about n log n.
/// @throws Cancelled
ArrivalField arrivalField(const CellGraph& cells, const GrowthGauge& gauge, const GrowthBed& bed,
                          Progress& progress);

}  // namespace lamina
