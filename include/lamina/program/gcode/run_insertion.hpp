// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/program/program_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How inserted runs are extruded, and how the nozzle travels to them.
struct InsertionSettings {
  ProgramSettings program;
  double travel_feed_mm_s = 150.0;
  double retraction_threshold_mm = 2.0;  ///< above this length, a travel retracts filament and hops
  double hop_mm = 0.0;                   ///< by which the nozzle is lifted in such a travel
};

/// The program with runs added at the end of its layers, right after the last line that deposits there. Every
/// line of the program stays as it is, byte for byte and in its order, and does what it did: inserted lines
/// start where the nozzle stands, return it there, and restore role, feed, mode and position of the filament.
/// The first line inserted in a layer is `;void fill`, the last `;end of void fill`. A layer without runs, or
/// in which the program deposits nothing, is left alone; without any run the result is the program.
///
/// @param toolpath  that `toolpathFromGcode` returned for the program
/// @param runs  for each layer of `toolpath`, in its frame
/// @throws InvalidInput if there are not as many layers, or they are inclined
/// @throws InvalidProgram if the program uses inches, relative positions while it deposits, or moves its
///   origin
std::string insertRuns(std::string_view program, const Toolpath& toolpath,
                       const std::vector<std::vector<Path>>& runs, const InsertionSettings& settings);

}  // namespace lamina
