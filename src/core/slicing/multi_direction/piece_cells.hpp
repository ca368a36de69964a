// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/slicing/volumetric/head_room.hpp"
#include "slicing/multi_direction/face_polygons.hpp"
#include "slicing/volumetric/cell_graph.hpp"

namespace lamina {

/// For each node of a part's cells, whether it has not been cut off yet.
using CellsLeft = std::vector<std::uint8_t>;

/// Requirements on a cut.
struct CutRules {
  double bed_mm = 0.0;
  double least_base_mm2 = 0.0;  ///< least area, on the cutting plane, of each connected part of a piece
  std::vector<HeadStage> head;
  double part_mm3 = 0.0;  ///< volume of all cells
};

/// Cells that a plane cuts off.
struct CutCells {
  double volume_mm3 = 0.0;
  double area_mm2 = 0.0;  ///< of the cut
  CellsLeft left;
};

/// Why a plane is not allowed as a cut: the head or the plane would be in the bed; a connected part of the
/// piece lies on too small a base; hardly any cells are above the plane; or what remains is not connected to
/// the bed.
enum class CutFault { None, InBed, SmallBase, SmallPiece, LooseRest };

/// A plane as a cut: what it cuts off, or why it is not allowed.
struct TriedCut {
  CutFault fault = CutFault::None;
  CutCells cells;  ///< of a cut without fault

  explicit operator bool() const { return fault == CutFault::None; }
};

/// Cuts off the cells above a plane, if the plane is allowed as a cut. Connected pieces smaller than a ten
/// thousandth of the part's volume need neither a base nor a connection to the bed.
TriedCut cutCells(const CellGraph& cells, const CellsLeft& left, const CuttingPlane& plane,
                  const CutRules& rules);

/// Position along `up` of the lowest plane across that direction with no remaining cell above it that lies at
/// the bed, or so near that the head would touch the bed [mm].
double lowestClearOfBed(const CellGraph& cells, const CellsLeft& left, const Point3& up,
                        const CutRules& rules);

/// Least height of the tip above the bed at which a head along the direction `up` does not touch the bed
/// [mm].
double leastTipHeight(const std::vector<HeadStage>& head, const Point3& up);

}  // namespace lamina
