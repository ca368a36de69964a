// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/program/program_frame.hpp"
#include "lamina/program/program_settings.hpp"

namespace lamina {

/// Start or end code with its placeholders replaced, every line ended. Lines whose placeholder stands for 0
/// are left out, so that the heater is left alone.
/// @param key    of the setting the code comes from, for the error
/// @param frame  gives the axis that lifts the nozzle
/// @throws InvalidConfig if a placeholder is unknown or not closed
std::string expandCode(const std::string& key, const std::string& code, const ProgramSettings& settings,
                       const ProgramFrame& frame);

}  // namespace lamina
