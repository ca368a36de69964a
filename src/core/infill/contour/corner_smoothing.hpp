// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/contour/smoothing_settings.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// The run with its corners, turns of 30 degrees and more, replaced by curves. The part of the run within
/// half a window of a corner, measured along the run, is replaced by a monotone cubic [Fritsch1980] between
/// the two ends of the window. The slopes at these ends are those of a curve through them and one more point
/// of the run on each side. Windows of neighbouring corners share the length between them, and no window
/// extends beyond an end of the run.
///
/// The curve stays within 0.56 windows of the run, and inside the bounding box of the ends of its window.
/// Straight parts and ends are unchanged; closed runs stay closed. A new point has the width of the run at
/// the same share of the window. Runs of drops are unchanged, and all runs are if the window is 0.
FillPath smoothed(FillPath run, const SmoothingSettings& settings);

/// The run with fewer of its points: those left out lie within the tolerance of the motion that replaces
/// them, with a width that differs by at most a hundredth. Ends are kept, and of a closed run the first point
/// and two more.
FillPath simplified(FillPath run, double tolerance_mm);

}  // namespace lamina
