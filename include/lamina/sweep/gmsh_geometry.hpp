// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/sweep/sweep.hpp"

namespace lamina {

/// The sweeps as a geometry script of Gmsh (.geo, OpenCASCADE kernel) [Vega2023, section 3.1]: a prism of the
/// profile for each line, with flat ends, and the profile revolved about the vertical axis through each
/// corner. Volumes overlap where beads do; all are in the physical volume "beads". Coordinates are in mm,
/// with 9 significant digits.
/// @throws InvalidInput if there is no sweep
std::string gmshGeometry(const std::vector<Sweep>& sweeps);

}  // namespace lamina
