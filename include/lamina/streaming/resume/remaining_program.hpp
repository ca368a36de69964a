// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// How a program of the rest of another begins.
struct ResumeSettings {
  double purge_mm3 = 30.0;                       ///< of material, beside the part
  std::vector<double> purge_at_mm{0.0, 0.0};     ///< x and y
  double clearance_mm = 5.0;                     ///< from the part, until the approach
  std::vector<double> tool_axis{0.0, 0.0, 1.0};  ///< from the tip into the tool; of any length
  double ramp_mm = 5.0;                          ///< deposited at half speed, whole lines
  double filament_diameter_mm = 1.75;
  double retraction_mm = 1.0;      ///< of filament, between purge and part
  double travel_feed_mm_s = 50.0;  ///< of the motions that are added
  double purge_feed_mm_s = 2.0;    ///< of filament
};

/// Adds the keys resume.*.
void describe(SettingsSchema& schema, ResumeSettings& settings);

/// The first line of a layer, counted as `ProgramCursor` gives them, from 1.
/// @throws InvalidInput if the program has no line in that layer
std::uint64_t firstLineOfLayer(const StreamableProgram& program, std::int32_t layer);

/// The first line that deposits at that height or above.
/// @param height_mm  z of the program
/// @throws InvalidInput if none does
/// @throws InvalidProgram as `GcodeReader`
std::uint64_t firstLineAtHeight(const StreamableProgram& program, double height_mm);

/// What must be seen to before the rest of a program is run, a sentence each.
struct RemainingProgramNotes {
  std::vector<std::string> to_check;
};

/// Writes a program that goes on with another after a machine has lost its position: bed hot, x and y homed
/// (never z, whose height is told instead), nozzle hot, all modes as the program has left them, a purge
/// beside the part, an approach from above along the tool axis, and then the program's lines from `from_line`
/// on, unchanged. It is only written: whether the part still holds, and where its last bead ends, somebody
/// has to see.
/// @param nozzle_height_mm  z of the nozzle, in the program's coordinates, when the rest begins
/// @throws InvalidInput if there is no such line, the nozzle stands too low to pass over the part, or the
///   purge would lie on it
/// @throws InvalidProgram as `GcodeReader`, and for volumetric extrusion (M200)
RemainingProgramNotes writeRemaining(const StreamableProgram& program, std::uint64_t from_line,
                                     double nozzle_height_mm, const ResumeSettings& settings,
                                     const TextSink& sink);

}  // namespace lamina
