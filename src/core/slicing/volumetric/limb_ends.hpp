// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "slicing/volumetric/cell_graph.hpp"
#include "slicing/volumetric/skin_parts.hpp"

namespace lamina {

/// A part whose ends are looked for, and how deep its nodes lie in it.
struct LimbQuestion {
  const Mesh& mesh;
  const CellGraph& cells;
  const std::vector<SkinPart>& skin;
  /// Depth by node [mm²]: the field with Laplacian -1 that is 0 at the bed and flows out through the bed
  /// only. It grows along limbs and hardly changes across them. Negative where growth does not reach.
  const std::vector<double>& depth_mm2;
};

/// The normal of the surface at nodes at the ends of limbs, 0 at the others. A limb lies deeper than the node
/// at which it joins a deeper limb, and extends more than three cells beyond that node. Its end is a
/// connected piece of the surface at its deepest node, flat or domed, that faces one direction within 60 deg.
/// Of several pieces the best by depth and flatness is taken. A piece that reaches far along the limb, like
/// the side of a tip, is no end, nor is a piece smaller than a side of a cell.
std::vector<Point3> limbEnds(const LimbQuestion& question);

}  // namespace lamina
