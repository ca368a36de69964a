// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/stiffness/load_case.hpp"
#include "stiffness/connected_parts.hpp"

namespace lamina {

/// The displacements that the load gives, and those that keep each part from sliding and turning across it:
/// of one resting node both components across, of another one. That much bears no force, so it
/// disturbs nothing.
GivenNodes givenNodes(const ElementLattice& lattice, const LoadCase& load, const ConnectedParts& parts);

}  // namespace lamina
