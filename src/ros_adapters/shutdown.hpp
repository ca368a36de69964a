// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace lamina {

/// A node from start to end: joins ROS under `name` (remappable), runs `body`, and leaves ROS. SIGINT and
/// SIGTERM request a shutdown, so that destructors run; `body` returns once `ros::ok()` is false, as
/// ros::spin() does.
///
/// Does not return: the process ends with exit code 0, or 1 if `body` threw; then the message was logged.
[[noreturn]] void runNode(int argc, char** argv, const std::string& name, const std::function<void()>& body);

}  // namespace lamina
