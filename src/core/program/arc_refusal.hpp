// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/program/program_settings.hpp"

namespace lamina {

/// @throws InvalidConfig naming what has no arcs
[[noreturn]] void refuseArcs(const ProgramSettings& settings, const std::string& where);

}  // namespace lamina
