// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/tools/tool_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Adds code that sets the temperatures of tools: a tool that is left goes to its `standby_c`, if it has one;
/// `heat_s` before it is taken again, by the time estimate, at the start of the last path that leaves it so
/// long, it is heated; and when it is taken, the machine waits until it is hot. A tool that is taken again
/// within `heat_s` stays hot. A tool with neither a temperature of its own nor one to stand by at is left
/// alone, and so is the first one used: start code heats it.
/// @param nozzle_temperature_c  of tools that have none of their own
void addToolHeating(Toolpath& toolpath, const std::vector<Tool>& tools, double nozzle_temperature_c,
                    const MotionLimits& limits);

}  // namespace lamina
