// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/base/progress.hpp"
#include "slicing/volumetric/cell_graph.hpp"
#include "slicing/volumetric/growth_gauge.hpp"

namespace lamina {

/// The bed below a part.
struct GrowthBed {
  double level_mm = 0.0;    ///< z of the bed
  double contact_mm = 0.1;  ///< height above the bed up to which solid cells count as standing on the bed
};

/// Growth at a place, and its gradient: it points across the layers, against the tool axis, and its length is
/// 1 over the relative thickness of the layer.
struct GrowthAt {
  double growth_mm = 0.0;
  Point3 gradient = Point3::UnitZ();
};

/// Share of a cell by which growth may exceed the height over the bed and still counts as level, as bits form
/// steps.
constexpr double kLevelCells = 0.01;

/// Growth at each node of a part: the nominal layer height deposited until the node is reached. It is the
/// least cost, by `GrowthGauge`, of all paths through the part from the bed to the node.
struct ArrivalField {
  std::vector<double> growth_mm;  ///< at the middles of the nodes; infinite if no path leads to the node
  std::vector<Point3> turn;       ///< point at which the last straight piece of the path to the node begins
  std::vector<double> turn_mm;    ///< growth at that point
  std::vector<char> is_level;     ///< whether growth at the node equals the height above the bed
  /// Gradient at the middle of each node, of a field that was fitted (`fittedGrowth`); empty for a field of
  /// paths.
  std::vector<Point3> fitted_gradient;
  std::size_t stands = 0;    ///< number of nodes that stand on the bed
  double contact_mm2 = 0.0;  ///< area of contact with the bed
  double bed_mm = 0.0;       ///< z of the bed

  /// Growth at a place near a node, which may lie beside the part: as if the path to the node continued to
  /// the place.
  GrowthAt near(const Point3& place, std::uint32_t node, const Point3& middle,
                const GrowthGauge& gauge) const;
};

/// Grows a part from the bed, node by node in the order of arrival. A path to a node is straight as long as
/// it stays in the part, and otherwise turns at bits of a node from which the next node is visible. The field
/// is therefore exact up to the size of a bit where the bed is visible from everywhere. It is level to within
/// 1e-9 mm where a path from the bed leans no more than the overhang. Growth of about 1 % of a cell above
/// level counts as level.
///
/// Each node is settled once; time is of order n log n in the number of nodes.
/// @throws Cancelled
ArrivalField arrivalField(const CellGraph& cells, const GrowthGauge& gauge, const GrowthBed& bed,
                          Progress& progress);

}  // namespace lamina
