// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "streaming/firmware/grbl/grbl_machine.hpp"

namespace lamina {

/// What every firmware of grbl's kin would refuse or misread in a command; empty if nothing.
/// @param longest  longest line [characters]; 0 for the longest of any of them
std::string defectForAllGrbl(std::string_view command, int longest);

/// What this machine would refuse or misread in a command, as far as it is known without the lines before;
/// empty if nothing. For grblHAL and FluidNC, which boards extend, it names only what no board takes.
std::string defectForGrbl(std::string_view command, const GrblMachine& machine);

/// Whether grbl may report Idle during a command, and takes nothing until its end: dwells, and spindles that
/// come up to speed.
bool mayStandStill(std::string_view command);

/// Whether a command turns a beam on at a power of its own (M3), so that it burns on where the lines stop
/// coming.
bool keepsLaserOn(std::string_view command);

}  // namespace lamina
