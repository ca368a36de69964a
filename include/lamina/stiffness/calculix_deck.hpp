// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/stiffness/stiffness.hpp"

namespace lamina {

/// Writes the elements, the material and the prescribed displacements of a result as an input deck for
/// CalculiX (`ccx`), for comparison. CalculiX then prints the displacements of all nodes and the reactions of
/// the fixed nodes. Nodes and elements are numbered from 1 in the order of the lattice.
/// @throws FileError if it cannot be written; an existing file is then unchanged
void writeCalculixDeck(const StiffnessResult& result, const ElasticMaterial& material,
                       const std::string& path);

}  // namespace lamina
