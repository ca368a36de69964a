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

/// How the nozzle is held, as RViz shows it: at the first waypoint of each deposition path and then about
/// every so many millimetres a frame, its x blue, y red and z, the tool axis, green, in the namespaces
/// `nozzle_x`, `nozzle_y` and `nozzle_z`. The first marker deletes those of an earlier toolpath. The colours
/// are those of [Flores2018, figure 43].
///
/// @param frame  that the markers are given in: the part frame
visualization_msgs::MarkerArray frameMarkers(const Toolpath& toolpath, const FrameSettings& settings,
                                             const std::string& frame);

/// The same frames, without the marker that deletes, for a viewer that shows some of the layers.
std::vector<MarkerChunk> frameMarkerChunks(const Toolpath& toolpath, const FrameSettings& settings,
                                           const std::string& frame);

}  // namespace lamina
