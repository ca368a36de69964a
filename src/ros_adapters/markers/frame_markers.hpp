// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "lamina/picture/frame_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "markers/toolpath_markers.hpp"

namespace lamina {

/// Markers of the nozzle's orientation: a frame at the first waypoint of each depositing path, and then at
/// about the interval of the settings. x is blue, y red, and z, the tool axis, green, in namespaces
/// `nozzle_x`, `nozzle_y` and `nozzle_z`; the colours are those of [Flores2018, figure 43]. The first marker
/// deletes those of an earlier toolpath.
///
/// @param frame  frame of the markers: that of the part
visualization_msgs::MarkerArray frameMarkers(const Toolpath& toolpath, const FrameSettings& settings,
                                             const std::string& frame);

/// The markers of `frameMarkers` without the deleting one, for a viewer that shows some of the layers.
std::vector<MarkerChunk> frameMarkerChunks(const Toolpath& toolpath, const FrameSettings& settings,
                                           const std::string& frame);

}  // namespace lamina
