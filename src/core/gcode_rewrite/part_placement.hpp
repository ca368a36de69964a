// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gcode_rewrite/survey.hpp"
#include "lamina/gcode_rewrite/rewrite_settings.hpp"

namespace lamina {

/// What moves the mapped part to its place over the bed [mm].
/// @throws InvalidProgram if the lift needs a layer height that is neither set nor reported
Point3 shiftOf(const Survey& survey, const RewriteSettings& settings);

/// @throws Unreachable naming line, axis, value and limit if the nozzle would leave the limits, deposit
/// below
///   the bed, or go to a final position out of the limits
void requireReachable(const Survey& survey, const Point3& shift, const RewriteSettings& settings);

/// @param nozzle  places it goes to over the bed, with the shift
/// @throws Unreachable as above
void requireWithinLimits(const Extremes& nozzle, const RewriteSettings& settings);

}  // namespace lamina
