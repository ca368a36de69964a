// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/cooling/cooling.hpp"

namespace lamina {

/// Leaves each island alone for the least layer time, counted from when the nozzle last left what lies
/// beneath it, in whatever layer, until it comes back. Islands of a layer are laid in the order in which
/// those beneath were left; what still lacks is waited for before each. Feeds stay. Where paths carry marks
/// of parts, tools change or layers are not plane, the order stays too.
CoolingSummary leavePlacesAlone(Toolpath& toolpath, const CoolingSettings& settings,
                                const MotionLimits& limits, Progress& progress);

}  // namespace lamina
