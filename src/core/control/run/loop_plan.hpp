// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/control/run/loop_run.hpp"

namespace lamina {

/// Why the layers left of a part should be planned anew after a layer, since amounts alone will not do; empty
/// where they will.
/// @param figures  of that layer
/// @param raised   alarms since the layer before was done
std::string reasonToPlan(const Toolpath& toolpath, const LayerFigures& figures,
                         const std::vector<RaisedAlarm>& raised, const LoopSettings& settings);

/// A new plan of the layers left of a part after a layer.
/// @param short_mm  distance by which the top of the part lies below that of the first toolpath
/// @throws InvalidInput if there is none, naming why
PrintPlan planOfLayersLeft(const PlacedPart& part, const LayerFigures& figures, double short_mm,
                           const LoopSettings& settings);

}  // namespace lamina
