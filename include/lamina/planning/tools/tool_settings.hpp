// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// One of several heads or nozzles of a machine.
struct Tool {
  std::string name;
  Point3 offset_mm = Point3::Zero();  ///< of its nozzle relative to that of tool 0
  double nozzle_mm = 0.0;             ///< 0 if not known
  std::string material;
  double temperature_c = 0.0;  ///< while the tool works; 0: the temperature of the program
  double standby_c = 0.0;      ///< while the tool waits; 0: unchanged
  double heat_s = 0.0;         ///< time before its next use at which the tool is heated again
};

/// The tools of a machine, their assignment to roles, and the purge at changes.
struct ToolSettings {
  SettingTable list;  ///< fields of `Tool` by number: "0.name"
  int walls = 0;
  int infill = 0;
  int skin = 0;
  int support = -1;    ///< -1: the tool of walls
  int interface = -1;  ///< -1: the tool of supports

  /// Volume of a purge: one for all changes, or one per pair, row by row from each tool; empty: no tower.
  std::vector<double> purge_mm3;
  bool purge_into_infill = false;   ///< as far as there is infill; only the rest goes into the tower
  double tower_mm = 0.0;            ///< side of the prime tower; 0: as wide as its purges need
  std::vector<double> tower_at_mm;  ///< x and y of its middle in the layers; empty: beside the part
};

/// Adds the keys tool.* and tools.*.
void describe(SettingsSchema& schema, ToolSettings& settings);

/// The tools of the list, in order; none if it is empty.
/// @throws InvalidConfig if an entry is no field of a tool, a value does not fit, or a number is missing
std::vector<Tool> toolsOf(const ToolSettings& settings);

/// Offsets of the nozzles of these tools, in order [bed frame].
std::vector<Point3> toolOffsets(const ToolSettings& settings);

/// Number of the tool that deposits paths of that role.
std::size_t toolFor(PathRole role, const ToolSettings& settings);

/// Whether `tool.*` assigns any role to another tool than the first.
bool assignsTools(const ToolSettings& settings);

/// @throws as `toolsOf`; InvalidConfig if a role has a tool that is not in the list, or volumes are neither
/// one nor one for each pair of tools, or there is none to purge into infill
void requireConsistent(const ToolSettings& settings);

}  // namespace lamina
