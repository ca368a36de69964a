// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/program/program_frame.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Writes the toolpath as G-code in the dialect that `program.dialect` names (`gcodeDialects`), in the
/// coordinates that `frame` gives: those of the bed, unless the axes are askew to it.
///
/// After the start code the program is in mm (G21), absolute (G90), with relative extrusion (M83). Each layer
/// opens with `;LAYER:k`, `;Z:` and `;HEIGHT:` and a motion that states X, Y, Z and F; from there on only
/// words that change are written. `;HEIGHT:` is repeated wherever the height of the beads changes, within a
/// path too, with 5 decimals. `;TYPE:role` opens a deposition path where the role changes or nothing else
/// would separate it from the path before. Positions have 3 decimals [mm], extrusion 5 [mm of filament],
/// feeds 3 [mm/min]; the remainder of each rounding of E is carried on: the sum of all E is that of the
/// toolpath within half a unit of the last decimal.
///
/// A toolpath of drops is written in the dialect `settings.drops`: a header of `;key=value`, a comment with
/// its role before each run of drops, and for each drop a motion and the command that releases it. It has no
/// extrusion and no retraction.
///
/// Layers that are inclined, a nozzle that does not point straight down, and axes askew to the bed are stated
/// in the header (`frameComments`); `;Z:` is the height of a layer along its normal. Each waypoint has its
/// own Z. Whatever the axes are, extrusion follows from lengths over the bed; a feed is the speed in axis
/// values at which the nozzle has the feed of the toolpath over the bed.
///
/// The nozzle first travels to the height of the first waypoint, then across. Filament is retracted before a
/// retracted path and extruded again after it; consecutive retracted paths share one retraction. Layers are
/// written by all threads in bounded memory; the text does not depend on the number of threads.
///
/// @param frame  pose of the part on the bed [mm]
/// @throws InvalidInput naming layer, path and waypoint, if the toolpath has no motion, has both beads and
///   drops, drops of several diameters, or events or process values for which the dialect has no command; if
///   a number is not finite or beyond 10 km, a feed is not positive, or the nozzle would have to rotate.
///   Everything is checked before the first piece is written.
/// @throws InvalidConfig if start or end code have a placeholder other than {nozzle_temperature_c},
///   {bed_temperature_c} and {lift_axis}, if a temperature is set for which the dialect has no heater, or if
///   arcs are set for drops or for layers that are not in a plane of two axes. A line whose placeholder has
///   the value 0 °C is left out.
void writeGcode(const Toolpath& toolpath, const ProgramFrame& frame, const ProgramSettings& settings,
                const TextSink& sink);

}  // namespace lamina
