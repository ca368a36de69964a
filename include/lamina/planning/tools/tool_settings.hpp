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
  Point3 offset_mm = Point3::Zero();  ///< offset of the nozzle from that of tool 0
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

  /// Volumes of purges: one for all changes, or one per pair of tools, row by row for each previous tool;
  /// empty: no tower.
  std::vector<double> purge_mm3;
  /// Purges go into infill as far as there is any; only the rest goes into the tower.
  bool purge_into_infill = false;
  double tower_mm = 0.0;            ///< side of the prime tower; 0: as wide as its purges need
  std::vector<double> tower_at_mm;  ///< x and y of the tower's middle in the layers; empty: beside the part
};

/// Adds the keys tool.* and tools.*.
void describe(SettingsSchema& schema, ToolSettings& settings);

/// The tools of the list, in order; none if it is empty.
/// @throws InvalidConfig if an entry is no field of a tool, a value does not fit, or a number is missing
std::vector<Tool> toolsOf(const ToolSettings& settings);

/// Offsets of the nozzles of all tools, in order [bed frame].
std::vector<Point3> toolOffsets(const ToolSettings& settings);

/// Number of the tool that deposits paths of that role.
std::size_t toolFor(PathRole role, const ToolSettings& settings);

/// Whether `tool.*` assigns any role to another tool than the first.
bool assignsTools(const ToolSettings& settings);

/// @throws as `toolsOf`; InvalidConfig if a role has a tool that is not in the list, if the volumes are
///   neither one nor one for each pair of tools, or if `purge_into_infill` is set without a volume
void requireConsistent(const ToolSettings& settings);

}  // namespace lamina
