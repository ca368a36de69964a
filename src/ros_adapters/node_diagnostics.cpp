// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node_diagnostics.hpp"

#include <utility>

namespace lamina {

void NodeDiagnostics::begin(const std::string& hardware, const std::string& name, const Fill& fill) {
  updater_.setHardwareID(hardware);
  updater_.add(name, fill);
}

void NodeDiagnostics::update() {
  const ros::Time now = ros::Time::now();
  if (now < std::exchange(last_, now))
    updater_.force_update();
  else
    updater_.update();
}

}  // namespace lamina
