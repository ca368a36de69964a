// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/slicing/volumetric/head_room.hpp"
#include "slicing/multi_direction/face_polygons.hpp"
#include "slicing/volumetric/cell_graph.hpp"

namespace lamina {

/// Which cells of a part are still to be cut, by nodes.
using CellsLeft = std::vector<std::uint8_t>;

/// What a cut has to hold to.
struct CutRules {
  double bed_mm = 0.0;
  double least_base_mm2 = 0.0;  ///< of each part of a piece, on its plane
  std::vector<HeadStage> head;
  double part_mm3 = 0.0;  ///< volume of all cells
};

/// What a plane cuts off.
struct CutCells {
  double volume_mm3 = 0.0;
  double area_mm2 = 0.0;  ///< of the cut
  CellsLeft left;
};

/// Cells above a plane, cut off; nothing if the plane is no cut: nothing is above it or the bed is, what
/// stays does not hang together with the bed, a part of the piece lies on less than it must, or the head
/// would be in the bed. Crumbs, below a ten thousandth of the part, may do as they like.
std::optional<CutCells> cutCells(const CellGraph& cells, const CellsLeft& left, const CuttingPlane& plane,
                                 const CutRules& rules);

/// The lowest plane across a direction over which the head is clear of the bed, and the bed itself is not
/// [mm along it].
double lowestClearOfBed(const CellGraph& cells, const CellsLeft& left, const Point3& up,
                        const CutRules& rules);

/// Height of the tip above the bed from which on a head along a direction is clear of it [mm].
double leastTipHeight(const std::vector<HeadStage>& head, const Point3& up);

}  // namespace lamina
