// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "lamina/slicing/unsliceable.hpp"

namespace lamina {

/// Why a part was refused, as RViz shows it: the region in red in the namespace `region`, the part behind it
/// half transparent in `part`, the reason over it in `reason`, a marker a line. The first marker deletes
/// those of an earlier refusal.
///
/// @param frame  that the markers are given in: the part frame
visualization_msgs::MarkerArray regionMarkers(const Unsliceable& refusal, const std::string& frame);

/// Deletes the markers of an earlier refusal.
visualization_msgs::MarkerArray noRegionMarkers(const std::string& frame);

}  // namespace lamina
