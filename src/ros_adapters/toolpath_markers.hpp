// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

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

}  // namespace lamina
