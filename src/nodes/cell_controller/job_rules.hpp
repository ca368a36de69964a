// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "cell_settings.hpp"
#include "lamina/base/progress.hpp"

namespace lamina {

/// Checks the whole file of a job for the cell's executor and machine: a program of G-code by its reach
/// (`requirePrintable`), a toolpath as `lamina check` does (`drivableRun`), without collisions if
/// `clearance.need` is never, and by the widest tolerances of a driver (`inTime`).
/// @param path  of the kept file, which is named by its digest
/// @param name  under which it was sent: stands in messages in place of the path
/// @return the number of layers; 0 if the file does not state it
/// @throws as these functions, `readToolpathOnBed`, and Cancelled
std::int32_t checkedLayers(const std::string& path, const std::string& name,
                           const CellControllerSettings& settings, Progress& progress);

/// The conditions for which a job is checked: the machine's sheet and, unless the executor is gcode_streamer,
/// the executor and its placement of jobs.
/// @throws as `machineSheet`
std::string jobSheet(const CellControllerSettings& settings);

}  // namespace lamina
