// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/job/job_settings.hpp"

namespace lamina {

/// Whether programs in `program.dialect` can set the pressure advance.
bool hasWordForAdvance(const JobSettings& settings);

/// Refuses settings that the firmware of a G-code program would ignore or stop at. Outputs of other formats
/// have no dialect.
/// @throws InvalidConfig naming the setting, its value and the dialect
void requireWordsOfDialect(const std::string& output, const JobSettings& settings);

}  // namespace lamina
