// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/control/run/loop_run.hpp"

namespace lamina {

/// Why the remaining layers of a part should be planned anew after a layer, because changes of amounts are
/// not enough; empty if they are.
/// @param figures  figures of that layer
/// @param raised   alarms raised since the layer before was finished
std::string reasonToPlan(const Toolpath& toolpath, const LayerFigures& figures,
                         const std::vector<RaisedAlarm>& raised, const LoopSettings& settings);

/// A new plan of the remaining layers of a part, after a layer.
/// @param short_mm  distance by which the top of the part lies below that of the first toolpath
/// @throws InvalidInput with the reason if there is no such plan
PrintPlan planOfLayersLeft(const PlacedPart& part, const LayerFigures& figures, double short_mm,
                           const LoopSettings& settings);

}  // namespace lamina
