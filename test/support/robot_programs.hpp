// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/program/robot/robot_writer.hpp"

namespace lamina::test {

/// A program where the part stands on the bed's origin, without an arm.
inline std::vector<RobotFile> robotFiles(RobotLanguage language, const Toolpath& toolpath,
                                         const RobotProgramSettings& settings = {},
                                         const std::string& name = "two_layers") {
  return robotProgram(toolpath, Eigen::Isometry3d::Identity(), {language, name, settings});
}

/// Laser power and speed of the wire that vary along paths that deposit.
inline Toolpath withValues(Toolpath toolpath, std::uint64_t seed) {
  Random random(seed);
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths) {
      if (path.role == PathRole::Travel) continue;
      std::vector<double> power;
      for (std::size_t i = 0; i < path.points.size(); ++i) power.push_back(random.uniform(100.0, 390.0));
      path.values.push_back({"laser_power_w", AlongPath<double>(std::move(power))});
      if (random.below(2) == 0)
        path.values.push_back({"wire_speed_mm_s", AlongPath<double>(random.uniform(1.0, 30.0))});
    }
  return toolpath;
}

}  // namespace lamina::test
