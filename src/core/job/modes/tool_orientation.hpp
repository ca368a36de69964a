// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/orientation/orientation_report.hpp"
#include "lamina/orientation/orientation_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Whether the settings hold the nozzle otherwise than the slicer does.
bool changesOrientation(const OrientationSettings& settings);

/// @param as_sliced  empty if nothing was changed
/// @throws InvalidInput if a tool axis was turned by more than `orientation.max_off_normal_deg` from the
/// layer's normal: it names the place; the nozzle would run into what is deposited
void requireNearNormal(const Toolpath& as_sliced, const Toolpath& oriented,
                       const OrientationSettings& settings);

/// What a user should know of how the nozzle turns, a sentence each: limits that were hit, walls that were
/// not found.
std::vector<std::string> notesOn(const OrientationReport& report);

}  // namespace lamina
