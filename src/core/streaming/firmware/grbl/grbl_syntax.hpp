// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "streaming/firmware/grbl/grbl_machine.hpp"

namespace lamina {

/// What all of grbl's kin would refuse or misread in a command; empty if nothing is.
/// @param longest  [characters]; 0 for the most that any of them takes
std::string defectForAllGrbl(std::string_view command, int longest);

/// What this machine would refuse or misread in a command, as far as it can be known without the lines
/// before; empty if nothing is. Of grblHAL and FluidNC, which boards extend, only what none of them takes.
std::string defectForGrbl(std::string_view command, const GrblMachine& machine);

}  // namespace lamina
