// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/stiffness/element_lattice.hpp"
#include "lamina/stiffness/node_field.hpp"

namespace lamina {

/// Adds to the nodes of the fine lattice what the coarse one holds, linearly along each axis between its
/// nodes.
void addInterpolated(const ElementLattice& coarse_lattice, const NodeField<float>& coarse,
                     const ElementLattice& fine_lattice, NodeField<float>& fine);

/// The transpose of that: forces on the nodes of the fine lattice gathered on those of the coarse one.
void gatherForces(const ElementLattice& fine_lattice, const NodeField<float>& fine,
                  const ElementLattice& coarse_lattice, NodeField<float>& coarse);

/// The coarse nodes on which a node depends that is given on the fine lattice.
GivenNodes givenOnCoarse(const ElementLattice& fine_lattice, const GivenNodes& given,
                         const ElementLattice& coarse_lattice);

}  // namespace lamina
