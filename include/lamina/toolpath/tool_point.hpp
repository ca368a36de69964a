// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The toolpath by which another point of the tool goes where the nozzle tip went, the tool held as it was:
/// the tip of a pointer, or a place ahead of the nozzle, so that the nozzle stays away from the part.
/// @param point_mm  in the nozzle's frame, whose z goes from the tip along the tool axis
Toolpath ledByPoint(Toolpath toolpath, const Point3& point_mm);

}  // namespace lamina
