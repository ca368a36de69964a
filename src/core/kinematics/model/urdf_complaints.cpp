// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/urdf_complaints.hpp"

namespace lamina {
namespace {

/// The parser has one handler for all threads.
std::mutex& handlerMutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

UrdfComplaints::UrdfComplaints() : alone_(handlerMutex()), usual_(console_bridge::getOutputHandler()) {
  console_bridge::useOutputHandler(this);
}

UrdfComplaints::~UrdfComplaints() { console_bridge::useOutputHandler(usual_); }

void UrdfComplaints::log(const std::string& text, console_bridge::LogLevel level, const char*, int) {
  if (level == console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_.empty()) first_ = text;
}

}  // namespace lamina
