// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The tool axis after the nozzle's body has been leaned along and across the path: first by `lead_deg` about
/// the axis across the path, towards the direction of travel, then by `tilt_deg` about the path's tangent, to
/// the left of the path as seen along it from the nozzle. The nozzle's tip stays where it is.
///
/// @param tool_axis  of unit length
/// @param tangent  direction of travel, of unit length
/// @return of unit length. A tool axis along the tangent has no axis across the path and stays as it is.
Point3 withLeadAndTilt(const Point3& tool_axis, const Point3& tangent, double lead_deg, double tilt_deg);

}  // namespace lamina
