// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <string>

namespace lamina::test {

/// A path in ROS_HOME, which every build folder has its own: tests of two checkouts that run at a time must
/// not meet.
inline std::string inRosHome(const std::string& name) {
  const char* home = std::getenv("ROS_HOME");
  return std::string(home == nullptr ? "/tmp" : home) + "/" + name;
}

}  // namespace lamina::test
