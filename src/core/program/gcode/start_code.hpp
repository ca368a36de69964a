// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/program/program_frame.hpp"
#include "lamina/program/program_settings.hpp"

namespace lamina {

/// Start or end code with its placeholders replaced and an end on every line. Lines with a placeholder whose
/// value is 0 are left out, so that the heater keeps its state.
/// @param key    name of the setting that holds the code, for the error
/// @param frame  states the axis that lifts the nozzle
/// @throws InvalidConfig if a placeholder is unknown or not closed
std::string expandCode(const std::string& key, const std::string& code, const ProgramSettings& settings,
                       const ProgramFrame& frame);

}  // namespace lamina
