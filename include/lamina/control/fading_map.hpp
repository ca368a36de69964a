// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/loop_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The relative amount by which a layer ends: that of the last cell of its last depositing path; 0 if the map
/// leaves that path as planned.
double lastAmount(const CorrectionMap& map, const ToolpathLayer& layer);

/// The map of a layer for which none came: the amount by which the layer before has ended fades to 0, no
/// faster than the feeder follows at the planned speed. Paths that it does not reach are as planned, and so
/// are all behind something that has no cells, which is as planned itself.
/// @param layer    of which the map is
/// @param number   of that layer
/// @param from     relative amount by which the layer before has ended
/// @param cell_mm  greatest distance of stations; positive
CorrectionMap fadingMap(const ToolpathLayer& layer, std::size_t number, double from, double cell_mm,
                        const LoopSettings& settings);

/// A map whose amounts go over from that by which the layer before has ended, no faster than the feeder
/// follows at the planned speed, as `fadedCorrection` has it.
/// @param map    with a station for each cell of that layer
/// @param layer  of which the map is
/// @param from   relative amount by which the layer before has ended
CorrectionMap fadedMap(CorrectionMap map, const ToolpathLayer& layer, double from,
                       const LoopSettings& settings);

}  // namespace lamina
