// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "lamina/geometry/vector.hpp"
#include "lamina/stiffness/stiffness.hpp"

namespace lamina {

/// Calls body(node, i, j, k) for each node of a lattice, in order.
template <class Body>
void forNodes(const ElementLattice& lattice, const Body& body) {
  for (int k = 0; k <= lattice.count()[2]; ++k)
    for (int j = 0; j <= lattice.count()[1]; ++j) {
      const int row = lattice.nodeRow(j, k);
      for (const NodeSpan* span = lattice.nodesBegin(row); span != lattice.nodesEnd(row); ++span)
        for (std::int32_t i = 0; i < span->count; ++i) body(span->node + i, span->begin + i, j, k);
    }
}

/// Calls body(run, i) for each element of a lattice, in order; the element has index i in the run.
template <class Body>
void forElements(const ElementLattice& lattice, const Body& body) {
  const int rows = lattice.count()[1] * lattice.count()[2];
  for (const ElementRun* run = lattice.elementsBegin(0); run != lattice.elementsEnd(rows - 1); ++run)
    for (std::int32_t i = 0; i < run->count; ++i) body(*run, i);
}

/// The nodes of an element in the order of VTK and Abaqus: around its lower face counter-clockwise seen from
/// above, then around its upper face.
inline std::array<std::int32_t, 8> nodesAround(const ElementRun& run, std::int32_t i) {
  const std::array<std::int32_t, 4>& n = run.node;
  return {n[0] + i, n[0] + i + 1, n[1] + i + 1, n[1] + i, n[2] + i, n[2] + i + 1, n[3] + i + 1, n[3] + i};
}

/// Position of a node [mm].
inline Point3 placeOf(const ElementModel& model, int i, int j, int k) {
  return model.corner + model.element_mm * Point3(i, j, k);
}

}  // namespace lamina
