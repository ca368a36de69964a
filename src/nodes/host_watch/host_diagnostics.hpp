// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <vector>

#include "lamina/cell/host_watch.hpp"
#include "messages.hpp"

namespace lamina {

/// The host's observations and its alarms: OK without any, an error if the master or a host that is needed is
/// lost, else a warning.
void fillDiagnostics(const lamina_msgs::HostState& host, const std::vector<HostAlarm>& alarms,
                     diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace lamina
