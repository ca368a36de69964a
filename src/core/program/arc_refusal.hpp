// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/program/program_settings.hpp"

namespace lamina {

/// Refuses `program.arcs_tolerance_mm` in a program that cannot have arcs.
/// @param where  the dialect or language, for the message
/// @throws InvalidConfig
[[noreturn]] void refuseArcs(const ProgramSettings& settings, const std::string& where);

}  // namespace lamina
