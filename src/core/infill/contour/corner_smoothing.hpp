// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/contour/smoothing_settings.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// The run with its corners, turns of 30 degrees and more, replaced by curves: what lies within half a window
/// along the run to either side of a corner becomes a monotone cubic [Fritsch1980] between the
/// two ends of the window, the slopes there those of a curve through these and one more point of the run on
/// each side. Windows of neighbouring corners share the way between them, and none reaches beyond an end of
/// the run.
///
/// The curve stays within 0.56 windows of the run and in the box round the ends of its window. Straight parts
/// and ends stay where they are; closed runs stay closed. Each new point takes the width of the run at the
/// same part of the window. Runs of drops stay as they are, and so do all if the window is 0.
FillPath smoothed(FillPath run, const SmoothingSettings& settings);

/// The run with fewer points, all of them its own: those left out lie within the tolerance of the motion that
/// replaces them, and the width there differs by a hundredth of itself at most. Ends stay; a closed run
/// keeps its first point and two more.
FillPath simplified(FillPath run, double tolerance_mm);

}  // namespace lamina
