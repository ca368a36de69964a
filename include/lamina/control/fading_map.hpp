// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/loop_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The relative amount at the end of a layer: at the last cell of its last depositing path; 0 if the map
/// leaves that path as planned.
double lastAmount(const CorrectionMap& map, const ToolpathLayer& layer);

/// The map of a layer that has received none: the amount at the end of the layer before fades to 0, no faster
/// than the feeder follows at the planned speed. Paths beyond the fade are as planned. So are paths without
/// cells, and all paths after them.
/// @param layer    layer of the map
/// @param number   number of the layer
/// @param from     relative amount at the end of the layer before
/// @param cell_mm  greatest distance of stations; positive
CorrectionMap fadingMap(const ToolpathLayer& layer, std::size_t number, double from, double cell_mm,
                        const LoopSettings& settings);

/// A map whose amounts begin at the amount at the end of the layer before, and change no faster than the
/// feeder follows at the planned speed (`fadedCorrection`).
/// @param map    with a station for each cell of the layer
/// @param layer  layer of the map
/// @param from   relative amount at the end of the layer before
CorrectionMap fadedMap(CorrectionMap map, const ToolpathLayer& layer, double from,
                       const LoopSettings& settings);

}  // namespace lamina
