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
  double nozzle_temperature_c = 0.0;  ///< of tools without a temperature of their own
  MotionLimits limits;
  CoolingSettings parking;  ///< lift and place of parking
};

/// Adds code that sets the temperatures of tools. A tool that is put away goes to its `standby_c`, if it has
/// one. It is heated again `heat_s` before its next use by the time estimate, at the start of the last path
/// that leaves that time, and the machine waits for its temperature when it changes to that tool, on
/// the prime tower if that is where it goes, and otherwise at the parking place, which the travel after the
/// change is led over, retracted; at a change without a travel, where the nozzle is. A tool that is used
/// again within `heat_s` stays hot. A tool without a temperature and a standby temperature of its own gets no
/// code, nor does the first use of the first tool, which start code heats.
void addToolHeating(Toolpath& toolpath, const std::vector<Tool>& tools, const ToolHeatingSite& site);

}  // namespace lamina
