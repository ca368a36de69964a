// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "planning/flow/path_cut.hpp"
#include "planning/runs/level_rules.hpp"

namespace lamina {

/// The places at the given lengths from the start of a path, in order; those at waypoints are left out.
std::vector<CutPlace> levelSteps(const Path& path, const std::vector<double>& ways_mm);

/// States the values of channels earlier by their dead times, so that their effect is in step with the
/// motion. A motion gets the value of the bead that is deposited one dead time later, in the same run or the
/// next. Times follow from the feeds, those of travels included. Over a travel longer than the dead time the
/// value is held. Travels state no values.
void leadLevels(Toolpath& toolpath, const std::vector<LevelChannel>& channels);

}  // namespace lamina
