// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/base/settings.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// One of several heads or nozzles of a machine.
struct Tool {
  std::string name;
  Point3 offset_mm = Point3::Zero();  ///< of its nozzle from that of tool 0
  double nozzle_mm = 0.0;             ///< 0 if not known
  std::string material;
  double temperature_c = 0.0;  ///< while it works; 0 is that of the program
  double standby_c = 0.0;      ///< while it waits; 0 keeps it as it is
  double heat_s = 0.0;         ///< before it is used it is heated again
};

/// What tools there are, which lays what, and what is done when they change.
struct ToolSettings {
  SettingTable list;  ///< of `Tool`, "0.name"
  int walls = 0;
  int infill = 0;
  int skin = 0;
  int support = -1;    ///< -1 is that of walls
  int interface = -1;  ///< -1 is that of supports

  std::vector<double>
      purge_mm3;  ///< one for all changes, or one for each pair, from tool by tool; none: no tower
  bool purge_into_infill = false;   ///< as much as there is of it, and only the rest into the tower
  double tower_mm = 0.0;            ///< side of the prime tower; 0 is as wide as its purges need
  std::vector<double> tower_at_mm;  ///< x and y of its middle in the layers; empty: beside the part
};

/// Adds the keys tool.* and tools.*.
void describe(SettingsSchema& schema, ToolSettings& settings);

/// The tools of the list, in order; none if it is empty.
/// @throws InvalidConfig if an entry is no tool's, a value does not fit, or a number is left out
std::vector<Tool> toolsOf(const ToolSettings& settings);

/// Which tool lays a path of that role.
std::size_t toolFor(PathRole role, const ToolSettings& settings);

/// Whether `tool.*` gives any role another tool than the first.
bool assignsTools(const ToolSettings& settings);

/// @throws as `toolsOf`; InvalidConfig if a role has a tool that is not in the list, or volumes are neither
/// one nor one for each pair of tools, or there is none to purge into infill
void requireConsistent(const ToolSettings& settings);

}  // namespace lamina
