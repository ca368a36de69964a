// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/control/report/loop_record.hpp"

namespace lamina {

/// The report of a print as one HTML page: errors and gains by layer, the error along each layer, error and
/// correction along the last layer, alarms, and a table of figures. The page embeds its pictures, has no
/// scripts and refers to no other file.
std::string loopReport(const LoopRecord& record);

/// The figures of the layers as CSV, a row per layer, lengths in mm.
std::string loopLayersCsv(const LoopRecord& record);

/// Writes `loop_report.html` and `loop_layers.csv` into a folder, which is created if it does not exist. Each
/// file is written completely or not at all. Without layers in the record nothing is written.
/// @throws FileError if one cannot be written
void saveLoopReport(const std::string& folder, const LoopRecord& record);

}  // namespace lamina
