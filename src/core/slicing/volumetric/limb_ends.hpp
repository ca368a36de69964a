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
  /// By nodes: 0 at the bed, from which it grows along limbs as the field whose Laplacian is -1 and that
  /// flows out through the bed only; across a limb it hardly changes [mm²]. Negative where growth does not
  /// come.
  const std::vector<double>& depth_mm2;
};

/// The normal of the surface at nodes at the ends of limbs, 0 at the others. A limb is what lies deeper than
/// a way out of it, by more than three cells along it. Its end is a connected piece of the surface at its
/// deepest node that faces one way within 60 deg, flat or domed: of several there, the one that lies deepest,
/// or is flatter. One that reaches far along the limb, as the side of a tip does, is none, nor is one smaller
/// than a cell's side.
std::vector<Point3> limbEnds(const LimbQuestion& question);

}  // namespace lamina
