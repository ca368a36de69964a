// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Returns the settings with the beads, pitches and feeds of the first layer.
PlanSettings onBed(PlanSettings settings);

/// Scales the volume of a layer's beads, which keep their heights. A factor of 1 changes nothing.
void scaleFlow(ToolpathLayer& layer, double factor);

}  // namespace lamina
