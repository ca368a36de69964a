// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "lamina/slicing/unsliceable.hpp"

namespace lamina {

/// Markers of the reason why a part was refused: the region in red in namespace `region`, the
/// half-transparent part in `part`, and the reason above it in `reason`, one marker for each line. The first
/// marker deletes those of an earlier refusal.
///
/// @param frame  frame of the markers: that of the part
visualization_msgs::MarkerArray regionMarkers(const Unsliceable& refusal, const std::string& frame);

/// A marker that deletes those of an earlier refusal.
visualization_msgs::MarkerArray noRegionMarkers(const std::string& frame);

}  // namespace lamina
