// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "planning/flow/path_cut.hpp"
#include "planning/runs/level_rules.hpp"

namespace lamina {

/// Places at ways from the start of a path, in order, without those at its waypoints.
std::vector<CutPlace> levelSteps(const Path& path, const std::vector<double>& ways_mm);

/// States the values of channels with a dead time earlier by that time, so that what they do is in step. A
/// motion has the value of the bead that is deposited after the dead time, of its own run or of the next.
/// Times are those at the feeds, also of travels; a value is held over a travel that is longer. On travels
/// nothing is stated.
void leadLevels(Toolpath& toolpath, const std::vector<LevelChannel>& channels);

}  // namespace lamina
