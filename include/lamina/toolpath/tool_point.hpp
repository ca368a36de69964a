// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The toolpath moved so that another point of the tool, instead of the nozzle tip, passes through the
/// waypoints; orientations are unchanged. The point may be the tip of a pointer, or a point ahead of the
/// nozzle that keeps the nozzle away from the part.
/// @param point_mm  the point in the nozzle's frame, whose z goes from the tip along the tool axis
Toolpath withToolPoint(Toolpath toolpath, const Point3& point_mm);

}  // namespace lamina
