// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/stiffness/element_lattice.hpp"
#include "lamina/stiffness/node_field.hpp"

namespace lamina {

/// Adds the values at the nodes of a coarse lattice to the nodes of a fine one, interpolated trilinearly.
void addInterpolated(const ElementLattice& coarse_lattice, const NodeField<float>& coarse,
                     const ElementLattice& fine_lattice, NodeField<float>& fine);

/// Adds forces at the nodes of a fine lattice to those of a coarse one: the transpose of `addInterpolated`.
void gatherForces(const ElementLattice& fine_lattice, const NodeField<float>& fine,
                  const ElementLattice& coarse_lattice, NodeField<float>& coarse);

/// The coarse nodes whose values influence a prescribed node of the fine lattice.
GivenNodes givenOnCoarse(const ElementLattice& fine_lattice, const GivenNodes& given,
                         const ElementLattice& coarse_lattice);

}  // namespace lamina
