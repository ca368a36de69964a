// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/cooling/cooling_settings.hpp"
#include "lamina/planning/tools/tool_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Where and within what limits tools are heated.
struct ToolHeatingSite {
  double nozzle_temperature_c = 0.0;  ///< temperature of tools without a temperature of their own
  MotionLimits limits;
  CoolingSettings parking;  ///< lift and place of parking
};

/// Adds code that sets the temperatures of tools. A tool that is put away cools to its `standby_c`, if it has
/// one. It is heated again `heat_s` before its next use by the time estimate, at the start of the last path
/// that leaves that time. A tool that is used again within `heat_s` stays hot. After the change to a heated
/// tool the machine waits for its temperature: on the prime tower if the next travel ends there, otherwise at
/// the parking place, over which this travel is led, retracted. Without such a travel it waits where the
/// nozzle is. The first use of the first tool gets no code if start code heats it: tool 0 at the program's
/// temperature. All other uses of a tool that has neither a temperature nor a standby temperature of its own
/// get no code.
void addToolHeating(Toolpath& toolpath, const std::vector<Tool>& tools, const ToolHeatingSite& site);

}  // namespace lamina
