// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Before each retracted travel that follows a run of beads, a way of `wipe_mm` along that run, back where it
/// is open, once more where it is closed: a travel at the run's feed, on which the share of the retraction
/// happens. The travel goes on from there. A way of 0 changes nothing.
/// @param layers  of one plane, joined by travels
void addWipes(std::vector<ToolpathLayer>& layers, const TravelSettings& settings);

/// Whether a travel is such a way along the run that comes before it.
bool isWipeAlong(const Path& run, const Path& travel);

}  // namespace lamina
