// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/program/program_frame.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Writes the toolpath as G-code in the dialect of FullControl GCode Designer ([Gleadall2021]; [Vega2023,
/// section 3.2.6]): a `;FLAVOR:` line and the start code, `;END OF THE START GCODE`, motions in mm with
/// relative extrusion (G0 travels, G1 deposits) and no comments, `;START OF THE END GCODE` and the end code.
/// Coordinates and feeds are written only where they change, with 3 decimals. Extrusion has 5 decimals; the
/// rounding error of each E is added to the next. Nothing is retracted, as the dialect has no command for it.
///
/// The nozzle first travels to above the first waypoint, then down to it.
///
/// @throws InvalidInput if `validate` refuses the toolpath, if it deposits nothing, or holds drops, events or
///   process values, or if its nozzle does not point straight down; all is checked before the first piece is
///   written
/// @throws InvalidConfig as `writeGcode`
void writeFullControl(const Toolpath& toolpath, const ProgramFrame& frame, const ProgramSettings& settings,
                      const TextSink& sink);

}  // namespace lamina
