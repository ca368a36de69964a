// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "streaming/firmware/grbl/grbl_machine.hpp"

namespace lamina {

/// What any firmware of the grbl family would refuse or misread in a command; empty if nothing.
/// @param longest  length of the longest line allowed [characters]; 0 for the longest of any firmware
std::string defectForAllGrbl(std::string_view command, int longest);

/// What this machine would refuse or misread in a command, judged without the lines before it; empty if
/// nothing. Boards extend grblHAL and FluidNC: for these firmwares, only what no board accepts is named.
std::string defectForGrbl(std::string_view command, const GrblMachine& machine);

/// Whether grbl may report Idle during a command, as in a dwell or while a spindle comes up to speed; grbl
/// runs no other command until its end.
bool mayStandStill(std::string_view command);

/// Whether a command turns a beam on at a constant power (M3): the beam stays on if no more lines arrive.
bool keepsLaserOn(std::string_view command);

}  // namespace lamina
