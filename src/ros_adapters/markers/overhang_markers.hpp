// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "lamina/verification/overhang/overhang.hpp"

namespace lamina {

/// What is deposited with nothing below it, as RViz shows it: lines as wide as the beads in the namespaces
/// `overhang` (red) and `bridge` (yellow), and a sphere where a run begins in the air, in `start_in_air`
/// (magenta). A marker holds some thousand segments. The first one deletes those of an earlier report; a
/// report without stretches gives that alone.
///
/// @param frame  that the markers are given in: the part frame
visualization_msgs::MarkerArray overhangMarkers(const OverhangReport& report, const std::string& frame);

}  // namespace lamina
