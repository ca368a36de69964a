// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "messages.hpp"

namespace lamina {

/// The unit and its alarms: OK, or a warning of what is only reported, or an error that holds, stops or
/// aborts the unit; alarms whose cause is gone warn until they are acknowledged.
void fillDiagnostics(const lamina_msgs::PackmlStatus& unit, const lamina_msgs::CellAlarms& alarms,
                     diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace lamina
