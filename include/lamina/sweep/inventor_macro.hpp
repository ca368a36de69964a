// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/sweep/sweep.hpp"

namespace lamina {

/// The sweeps as a macro of Autodesk Inventor (VBA module, .bas) [Vega2023, section 3.1], which works in the
/// open part document. Each sweep becomes a solid body: its profile on a work plane, swept along its lines.
/// Sweeps are cut at corners of more than 90 degrees, and at lines shorter than 0.24 mm, half the width of
/// the bead there; loops are cut before their last line. Coordinates are in mm, with 6 decimals; the macro
/// converts them to Inventor's cm.
/// @throws InvalidInput if there is no sweep
std::string inventorMacro(const std::vector<Sweep>& sweeps);

}  // namespace lamina
