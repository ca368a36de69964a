// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "messages.hpp"

namespace lamina {

/// The unit and its alarms: OK, a warning for alarms that are only reported, or an error for alarms that
/// hold, stop or abort the unit. Alarms whose cause is gone are warnings until they are acknowledged.
void fillDiagnostics(const lamina_msgs::PackmlStatus& unit, const lamina_msgs::CellAlarms& alarms,
                     diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace lamina
