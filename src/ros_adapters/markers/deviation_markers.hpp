// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstddef>
#include <string>

#include "lamina/control/run/loop_run.hpp"

namespace lamina {

/// The colour of a deviation [mm], measured less planned: white as planned, red too high, blue too low, full
/// at `full_mm` and beyond.
std_msgs::ColorRGBA deviationColour(double deviation_mm, double full_mm);

/// A layer that is done as beads in the colours of its deviation: a line of each cell, as wide as its bead,
/// in namespace `beads` with the layer of the print as id, so that the layers of a part stay side by side.
/// Cells that were not seen are grey. Colours are full at a quarter of the layer's planned height. Two texts
/// in namespace `scale`, above the middle of the layer, state layer and error, and what the colours mean;
/// they are the same markers for all layers.
/// @param layers_below  number of layers of the print below the first one of its toolpath: those that were
///   deposited before the layers left were planned anew, as a plan counts its layers from 0
/// @param frame_from_part  of the markers' frame
visualization_msgs::MarkerArray deviationMarkers(const LayerOutcome& layer, std::size_t layers_below,
                                                 const std::string& frame,
                                                 const Eigen::Isometry3d& frame_from_part);

/// Deletes what was shown of the print before.
visualization_msgs::MarkerArray noDeviationMarkers(const std::string& frame);

}  // namespace lamina
