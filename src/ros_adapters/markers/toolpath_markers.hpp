// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The toolpath as RViz shows it: lines a quarter as wide as the beads, coloured by role, one namespace per
/// role so that each can be switched off; travel is thin and nearly transparent; drops are spheres of their
/// own size, pressed to the layer's height. A marker holds some thousand
/// segments of whole layers, so that RViz copes with millions. The first marker deletes those of an earlier
/// toolpath.
///
/// @param frame  that the markers are given in: the part frame
visualization_msgs::MarkerArray toolpathMarkers(const Toolpath& toolpath, const std::string& frame);

/// One of the markers of a toolpath, and which layers its points belong to.
struct MarkerChunk {
  visualization_msgs::Marker marker;
  std::size_t first_layer = 0;
  /// Points of the layers from the first one up to and with layer first_layer + i.
  std::vector<std::uint32_t> points_up_to;
};

/// The same markers, without the one that deletes, for a viewer that shows some of the layers.
std::vector<MarkerChunk> toolpathMarkerChunks(const Toolpath& toolpath, const std::string& frame);

}  // namespace lamina
