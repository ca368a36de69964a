// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Markers of a toolpath: lines a quarter as wide as the beads, coloured by role, with a namespace for each
/// role so that each can be switched off. Travels are thin and nearly transparent; drops are spheres of their
/// own size, flattened to the layer's height. A marker holds some thousand segments of whole layers, so that
/// RViz can show millions. The first marker deletes those of an earlier toolpath.
///
/// @param frame  frame of the markers: that of the part
visualization_msgs::MarkerArray toolpathMarkers(const Toolpath& toolpath, const std::string& frame);

/// A marker of a toolpath, and to which layers its points belong.
struct MarkerChunk {
  visualization_msgs::Marker marker;
  std::size_t first_layer = 0;
  /// For each i, the number of points that belong to layers up to and including first_layer + i.
  std::vector<std::uint32_t> points_up_to;
};

/// The markers of `toolpathMarkers` without the deleting one, for a viewer that shows some of the layers.
std::vector<MarkerChunk> toolpathMarkerChunks(const Toolpath& toolpath, const std::string& frame);

}  // namespace lamina
