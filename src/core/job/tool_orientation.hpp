// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/orientation/orientation_report.hpp"
#include "lamina/orientation/orientation_settings.hpp"

namespace lamina {

/// Whether the settings hold the nozzle otherwise than the slicer does.
bool changesOrientation(const OrientationSettings& settings);

/// What a user should know of how the nozzle turns, a sentence each: limits that were hit, walls that were
/// not found.
std::vector<std::string> notesOn(const OrientationReport& report);

}  // namespace lamina
