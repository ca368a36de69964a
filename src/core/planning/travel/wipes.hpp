// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Inserts a wipe before each retracted travel that follows a run of beads. A wipe is a travel of length
/// `wipe_mm` at the run's feed: back along an open run, or once more along the start of a closed one. The
/// share `wipe_share` of the retraction happens during it. The retracted travel then starts at the end of the
/// wipe. Without effect if `wipe_mm` is 0.
/// @param layers  of one plane, joined by travels
void addWipes(std::vector<ToolpathLayer>& layers, const TravelSettings& settings);

/// Whether `travel` is a wipe along `run`, which comes before it.
bool isWipeAlong(const Path& run, const Path& travel);

}  // namespace lamina
