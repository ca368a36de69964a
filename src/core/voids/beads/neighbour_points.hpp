// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/voids/beads/void_points.hpp"

namespace lamina {

/// Places beside drops at the edge of a void, in the order of the drops: a diameter away from the drop, or as
/// near as allowed if there is no room for that.
std::vector<VoidPoint> neighbourPoints(const std::vector<Point2>& drops, const VoidSearch& search);

}  // namespace lamina
