// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// First line of a toolpath as CSV.
constexpr const char* kCsvHeader =
    "layer,path,role,closed,x_mm,y_mm,z_mm,qw,qx,qy,qz,bead_width_mm,bead_height_mm,feed_mm_s";

/// Writes the toolpath as comma-separated values in the part frame: the header, then one row for each motion
/// target, in order. A path begins with a row for where it starts; a closed path ends with a row that repeats
/// that position. Layers and the paths of each layer count from 0; `closed` is 1 or 0; the quaternion is
/// part_from_nozzle; a travel has bead width 0. Bead and feed stand in the row of the waypoint they lead to.
/// Numbers are the shortest that read back to the same double.
///
/// Further columns, each only where the toolpath needs it, in this order. `deposit`: `bead`, or `drops` where
/// a drop of that width and height falls at each row's position and nothing on the way. `tool`, from 0.
/// `events`, before the row's motion, separated by |; behind `after:` those that come after it: "dwell=2.5",
/// "fan=0.4", "pause=insert nuts", "code=M117 hot", "moving_code=G28", with bytes other than printable ASCII,
/// and , | % as % and two hexadecimal digits. One column for each process value, under its name,
/// empty where a path has none.
///
/// Inclined layers are stated by a line before the header, `#LAYER_FRAME:` and part_from_layers as w x y z.
///
/// Retraction, the part's name and layers without paths do not appear.
///
/// @throws InvalidInput if `validate` refuses the toolpath, or the name of a process value can be no column,
/// before the first piece is written
void writeCsv(const Toolpath& toolpath, const TextSink& sink);

}  // namespace lamina
