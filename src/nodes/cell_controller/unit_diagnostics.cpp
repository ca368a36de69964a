// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "unit_diagnostics.hpp"

#include <string>

namespace lamina {
namespace {

using diagnostic_msgs::DiagnosticStatus;

DiagnosticStatus::_level_type levelOf(const lamina_msgs::CellAlarm& alarm) {
  if (alarm.category == "I") return DiagnosticStatus::OK;
  return alarm.is_gone || alarm.category == "W" ? DiagnosticStatus::WARN : DiagnosticStatus::ERROR;
}

}  // namespace

void fillDiagnostics(const lamina_msgs::PackmlStatus& unit, const lamina_msgs::CellAlarms& alarms,
                     diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  diagnostics.summary(DiagnosticStatus::OK, unit.state_name);
  for (const lamina_msgs::CellAlarm& alarm : alarms.alarms)
    diagnostics.mergeSummary(levelOf(alarm), std::to_string(alarm.id) + ": " + alarm.message);
  diagnostics.add("state", unit.state_name);
  diagnostics.add("mode", unit.mode_name);
  diagnostics.add("job", unit.job.id);
  diagnostics.add("lines acknowledged", unit.lines_acknowledged);
  diagnostics.add("lines in all", unit.lines);
  diagnostics.add("parts", unit.parts);
  diagnostics.add("defective parts", unit.defective);
  diagnostics.add("active alarms", alarms.alarms.size());
  diagnostics.add("remote access", unit.remote_access != 0 ? "allowed" : "locked");
}

}  // namespace lamina
