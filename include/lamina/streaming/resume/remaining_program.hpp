// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// Settings for a program that continues another one (`writeRemaining`).
struct ResumeSettings {
  double purge_mm3 = 30.0;                    ///< volume that is purged beside the part
  std::vector<double> purge_at_mm{0.0, 0.0};  ///< position of the purge, x and y
  double clearance_mm = 5.0;  ///< least distance of nozzle and purge from the part until the approach
  std::vector<double> tool_axis{0.0, 0.0, 1.0};  ///< direction from the tip into the tool, of any length
  double ramp_mm = 5.0;  ///< length that is deposited at half speed, rounded up to whole lines
  double filament_diameter_mm = 1.75;
  double retraction_mm = 1.0;      ///< length of filament that is retracted between purge and part
  double travel_feed_mm_s = 50.0;  ///< feed of the travels that are added
  double purge_feed_mm_s = 2.0;    ///< feed of the filament during purge and retraction
};

/// Adds the keys resume.*.
void describe(SettingsSchema& schema, ResumeSettings& settings);

/// Number of the first line of a layer. Lines are commands as `ProgramCursor` reads them, counted from 1.
/// @throws InvalidInput if the program has no line in that layer
std::uint64_t firstLineOfLayer(const StreamableProgram& program, std::int32_t layer);

/// Number of the first line that deposits material at a height or above it.
/// @param height_mm  z in the program's coordinates
/// @throws InvalidInput if no line does
/// @throws InvalidProgram as `GcodeReader`
std::uint64_t firstLineAtHeight(const StreamableProgram& program, double height_mm);

/// Conditions that a person must check before the rest of a program is run, one sentence each.
struct RemainingProgramNotes {
  std::vector<std::string> to_check;
};

/// Writes a program that continues another one after the machine has lost its position. It heats the bed,
/// homes x and y (not z, whose height is given), heats the nozzle, restores all modes, purges beside the
/// part, approaches from above along the tool axis, and ends with the lines of the other program from
/// `from_line` on, unchanged. A person must check whether the part still adheres and where its last bead
/// ends.
/// @param nozzle_height_mm  z of the nozzle, in the program's coordinates, when the new program is started
/// @throws InvalidInput if there is no such line, the nozzle is too low to pass over the part, or the purge
///   is closer to the part than `clearance_mm`
/// @throws InvalidConfig if the tool axis does not point upwards by at least a tenth of its length
/// @throws InvalidProgram as `GcodeReader`, and for volumetric extrusion (M200)
RemainingProgramNotes writeRemaining(const StreamableProgram& program, std::uint64_t from_line,
                                     double nozzle_height_mm, const ResumeSettings& settings,
                                     const TextSink& sink);

}  // namespace lamina
