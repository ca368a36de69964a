// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "cell_settings.hpp"
#include "lamina/base/progress.hpp"

namespace lamina {

/// Checks a job's file whole, for the cell's executor and machine: a program of G-code by its reach
/// (`requirePrintable`), a toolpath as `lamina check` does (`drivableRun`), without collisions if
/// `clearance.need` is never, and by the widest tolerances of a driver (`inTime`).
/// @return the number of layers; 0 if the file does not say it
/// @throws as these functions, `readToolpathOnBed`, and Cancelled
std::int32_t checkedLayers(const std::string& path, const CellControllerSettings& settings,
                           Progress& progress);

/// What a job is checked for: the machine's sheet, and the executor and how it places jobs unless that is
/// gcode_streamer.
/// @throws as `machineSheet`
std::string jobSheet(const CellControllerSettings& settings);

}  // namespace lamina
