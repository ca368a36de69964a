// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/stiffness/stiffness.hpp"

namespace lamina {

/// Writes the same elements, material and given displacements as an input deck for CalculiX (`ccx`), which
/// prints the displacements of all nodes and the reactions of the nodes at rest. Nodes and elements are
/// numbered from 1 in the order of the lattice.
/// @throws FileError if it cannot be written; then what was there stays
void writeCalculixDeck(const StiffnessResult& result, const ElasticMaterial& material,
                       const std::string& path);

}  // namespace lamina
