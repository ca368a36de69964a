// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/slicing/adapted/adapted_layers.hpp"

namespace lamina {

/// The curve with its positions averaged over a window and no two points farther apart than the step. The
/// average wraps on a closed curve; on an open one the window shrinks evenly towards the ends. Points
/// within a tenth of a step of the one before them are left out where the curve stays the same within 1 µm.
/// @param smoothing_window  odd; 1 is none
AdaptedCurve finishedCurve(const AdaptedCurve& curve, double step_mm, int smoothing_window);

}  // namespace lamina
