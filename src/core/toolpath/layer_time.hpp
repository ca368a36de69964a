// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/toolpath/timing.hpp"

namespace lamina {

/// Time of one layer from rest to rest [s]: as `estimateTime` of a toolpath with this layer alone.
double layerTime(const ToolpathLayer& layer, const MotionLimits& limits);

}  // namespace lamina
