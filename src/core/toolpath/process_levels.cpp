// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/process_levels.hpp"

#include <algorithm>
#include <optional>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

std::optional<ProcessLevel> levelOf(const std::string& name) {
  for (const ProcessLevel level : kAllProcessLevels)
    if (level != ProcessLevel::Fan && name == nameOf(level)) return level;
  return std::nullopt;
}

/// Why a process value is no level, as the rest of a sentence; empty if it is one.
std::string defectOfLevel(const ProcessValue& value) {
  if (!levelOf(value.name))
    return "cannot be carried; known are laser_power_w, wire_speed_mm_s, screw_rpm, powder_g_min, gas_l_min";
  for (const double each : value.value.values())
    if (!(each >= 0.0 && std::isfinite(each)))
      return "is " + numberText(each) + "; must be a finite number of 0 or more";
  return {};
}

}  // namespace

const char* nameOf(ProcessLevel level) {
  switch (level) {
    case ProcessLevel::LaserPower:
      return "laser_power_w";
    case ProcessLevel::WireSpeed:
      return "wire_speed_mm_s";
    case ProcessLevel::ScrewSpeed:
      return "screw_rpm";
    case ProcessLevel::Powder:
      return "powder_g_min";
    case ProcessLevel::Gas:
      return "gas_l_min";
    case ProcessLevel::Fan:
      return "fan";
  }
  return "";
}

ProcessLevels levelsTo(const Path& path, std::size_t waypoint) {
  ProcessLevels levels;
  for (const ProcessValue& value : path.values)
    if (const auto level = levelOf(value.name)) levels[*level] = value.value.at(waypoint);
  return levels;
}

void requireLevels(const Toolpath& toolpath, const std::string& by) {
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p)
      for (const ProcessValue& value : toolpath.layers[l].paths[p].values) {
        const std::string defect = defectOfLevel(value);
        if (!defect.empty())
          throw InvalidInput("toolpath layer " + std::to_string(l) + ", path " + std::to_string(p) +
                             ": process value '" + value.name + "' " + defect + "; asked of " + by);
      }
}

}  // namespace lamina
