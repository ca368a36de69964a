// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace lamina {

enum class LogLevel { Debug, Info, Warning, Error };

/// Function that receives the core's log lines, for ROS, a terminal or a test. It is called from any thread;
/// an empty function discards the lines.
using LogSink = std::function<void(LogLevel level, const std::string& line)>;

/// A sink that discards every line.
inline LogSink silentLog() {
  return [](LogLevel, const std::string&) {};
}

}  // namespace lamina
