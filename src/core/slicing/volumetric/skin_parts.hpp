// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "slicing/volumetric/cell_graph.hpp"

namespace lamina {

/// Part of the surface near a node.
struct SkinPart {
  std::uint32_t node = CellGraph::kNone;
  std::uint32_t triangle = 0;
  Point3 normal = Point3::Zero();
};

/// Parts of the surface by nodes, in ascending order; parts of one node with the same normal are merged. A
/// node without parts, only a sliver at the skin, takes those of its neighbours farther in.
/// @throws Cancelled
std::vector<SkinPart> skinParts(const Mesh& mesh, const CellGraph& cells, Progress& progress);

/// The parts at a node, of parts by nodes.
std::pair<const SkinPart*, const SkinPart*> partsAt(const std::vector<SkinPart>& parts, std::uint32_t node);

}  // namespace lamina
