// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/cooling/cooling.hpp"

namespace lamina {

/// Makes sure that at least the least layer time passes between leaving an island and depositing the island
/// above it. Islands are deposited in the order in which the islands below were finished. Before an island
/// the nozzle waits for the remaining time. Feeds are not changed. The order is not changed either if paths
/// have part marks, tools change, or layers are not plane.
CoolingSummary leavePlacesAlone(Toolpath& toolpath, const CoolingSettings& settings,
                                const MotionLimits& limits, Progress& progress);

}  // namespace lamina
