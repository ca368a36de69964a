// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "lamina/verification/overhang/overhang.hpp"

namespace lamina {

/// Markers of material deposited with nothing below it: lines as wide as the beads in namespaces `overhang`
/// (red) and `bridge` (yellow), and in `start_in_air` a magenta sphere where a run begins in the air. A
/// marker holds some thousand segments. The first one deletes those of an earlier report; a report without
/// such material has this one only.
///
/// @param frame  frame of the markers: that of the part
visualization_msgs::MarkerArray overhangMarkers(const OverhangReport& report, const std::string& frame);

}  // namespace lamina
