// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/cooling/cooling.hpp"

namespace lamina {

/// Makes the least layer time pass between the nozzle's leaving an island, of any layer, and its coming back
/// to the one above. Islands of a layer are deposited in the order in which those below them were left; the
/// nozzle waits before an island for the time that still lacks. Feeds stay. If paths have marks of parts,
/// tools change or layers are not plane, the order stays too.
CoolingSummary leavePlacesAlone(Toolpath& toolpath, const CoolingSettings& settings,
                                const MotionLimits& limits, Progress& progress);

}  // namespace lamina
