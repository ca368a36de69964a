// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "log_bridge.hpp"

#include <ros/console.h>

namespace lamina {
namespace {

void passOn(LogLevel level, const std::string& line) {
  switch (level) {
    case LogLevel::Debug:
      ROS_DEBUG_STREAM(line);
      break;
    case LogLevel::Info:
      ROS_INFO_STREAM(line);
      break;
    case LogLevel::Warning:
      ROS_WARN_STREAM(line);
      break;
    case LogLevel::Error:
      ROS_ERROR_STREAM(line);
      break;
  }
}

}  // namespace

LogSink rosLog() { return passOn; }

}  // namespace lamina
