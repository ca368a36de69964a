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
  double retraction_threshold_mm = 2.0;  ///< length above which a travel is retracted and hops
  double hop_mm = 0.0;                   ///< height by which the nozzle is lifted in such a travel
};

/// The program with runs added at the end of its layers, directly after the last line that deposits there.
/// Every line of the program is kept byte for byte, in its order and with its effect: inserted lines start at
/// the present position of the nozzle, return it there, and restore role, feed, mode and filament position.
/// The first line inserted in a layer is `;void fill`, the last `;end of void fill`. A layer without runs, or
/// in which the program deposits nothing, is not changed; without any runs the result is the program itself.
///
/// @param toolpath  result of `toolpathFromGcode` for this program
/// @param runs  runs of each layer of `toolpath`, in the frame of the toolpath
/// @throws InvalidInput if `runs` has another number of layers than `toolpath`, or layers are inclined
/// @throws InvalidProgram if the program uses inches, relative positions while it deposits, or moves its
///   origin
std::string insertRuns(std::string_view program, const Toolpath& toolpath,
                       const std::vector<std::vector<Path>>& runs, const InsertionSettings& settings);

}  // namespace lamina
