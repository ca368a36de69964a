// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/sweep/sweep.hpp"

namespace lamina {

/// The sweeps as a macro of Autodesk Inventor (VBA module, .bas) [Vega2023, section 3.1]: for each one its
/// profile on a work plane and a sweep along its lines, each a solid body of its own, in the part document
/// that is open. Sweeps are cut where lines turn by more than 90 degrees and at lines shorter than half a
/// bead of 0.48 mm. Coordinates are in mm, which the macro turns into Inventor's cm; 6 decimals.
/// @throws InvalidInput if there is no sweep
std::string inventorMacro(const std::vector<Sweep>& sweeps);

}  // namespace lamina
