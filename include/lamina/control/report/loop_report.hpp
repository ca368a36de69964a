// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/control/report/loop_record.hpp"

namespace lamina {

/// One page that a person can read, print and send: errors and gains by layer, the error along each layer,
/// error and correction along the last one, alarms, and the numbers. HTML with its pictures inside, without
/// scripts, nothing from elsewhere.
std::string loopReport(const LoopRecord& record);

/// The numbers as comma-separated rows, one a layer, lengths in mm.
std::string loopLayersCsv(const LoopRecord& record);

/// Writes `loop_report.html` and `loop_layers.csv` into a folder, which is made if need be. Each appears
/// whole or not at all. Nothing is written of a record without layers.
/// @throws FileError
void saveLoopReport(const std::string& folder, const LoopRecord& record);

}  // namespace lamina
