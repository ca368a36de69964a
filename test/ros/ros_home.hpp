// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace lamina::test {

/// A path in ROS_HOME, which every build folder has its own: tests of two checkouts that run at a time must
/// not meet.
/// @throws std::runtime_error if there is no ROS_HOME
inline std::string inRosHome(const std::string& name) {
  const char* home = std::getenv("ROS_HOME");
  if (home == nullptr) throw std::runtime_error("ROS_HOME is not set; the tests need a folder of their own");
  return std::string(home) + "/" + name;
}

}  // namespace lamina::test
