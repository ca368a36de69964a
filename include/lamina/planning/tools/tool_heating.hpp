// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/tools/tool_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Adds code that sets the temperatures of tools. A tool that is put away goes to its `standby_c`, if it has
/// one. It is heated again `heat_s` before its next use by the time estimate, at the start of the last path
/// that leaves that time, and the machine waits for its temperature when it changes to that tool, on
/// the prime tower if that is where it goes. A tool that is used again within `heat_s` stays hot. A tool
/// without a temperature and a standby temperature of its own gets no code, nor does the first use of the
/// first tool, which start code heats.
/// @param nozzle_temperature_c  for tools without a temperature of their own
void addToolHeating(Toolpath& toolpath, const std::vector<Tool>& tools, double nozzle_temperature_c,
                    const MotionLimits& limits);

}  // namespace lamina
