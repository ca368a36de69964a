// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// First columns of the header of a toolpath as CSV.
constexpr const char* kCsvHeader =
    "layer,path,role,closed,x_mm,y_mm,z_mm,qw,qx,qy,qz,bead_width_mm,bead_height_mm,feed_mm_s";

/// Writes the toolpath as comma-separated values in the part frame: the header, then one row for each motion
/// target, in order. The first row of a path states where it starts; a closed path ends with a row that
/// repeats that position. Layers and the paths of each layer count from 0; `closed` is 1 or 0; the quaternion
/// is part_from_nozzle; a travel has bead width 0. Bead and feed of a motion are in the row of the waypoint
/// to which it leads. Numbers are the shortest that read back to the same double.
///
/// Further columns follow in this order, each only if the toolpath needs it:
/// - `deposit`: `bead`, or `drops` if the path deposits a drop of that width and height at the position of
///   each row and nothing in between.
/// - `tool`: number of the tool, from 0.
/// - `events`, separated by |: events before the row's motion, and with the prefix `after:` events after it.
///   Examples are "dwell=2.5", "fan=0.4", "pause=insert nuts", "code=M117 hot", "moving_code=G28". Bytes
///   other than printable ASCII, and the characters , | %, are written as % and two hexadecimal digits.
/// - one for each process value, under its name; empty in paths that have no such value.
///
/// If layers are inclined, a line before the header states part_from_layers: `#LAYER_FRAME:` and w x y z.
///
/// Retraction, the part's name and layers without paths are not written.
///
/// @throws InvalidInput if `validate` refuses the toolpath, or the name of a process value cannot be the name
///   of a column; both are checked before the first piece is written
void writeCsv(const Toolpath& toolpath, const TextSink& sink);

}  // namespace lamina
