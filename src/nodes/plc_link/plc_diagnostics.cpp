// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plc_diagnostics.hpp"

namespace lamina {

void fillDiagnostics(const lamina_msgs::PlcInputs& said, const PlcReach& reach,
                     diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  using diagnostic_msgs::DiagnosticStatus;
  using Said = lamina_msgs::PlcInputs;
  diagnostics.summary(DiagnosticStatus::OK, "the PLC's heartbeat comes");
  if (said.watchdog == Said::UNARMED)
    diagnostics.summary(DiagnosticStatus::WARN, "no heartbeat of a PLC has come yet");
  if (said.watchdog == Said::LOST || said.watchdog == Said::ABANDONED)
    diagnostics.summary(DiagnosticStatus::ERROR, "the PLC's heartbeat does not come");
  if (!reach.is_unit_here)
    diagnostics.mergeSummary(DiagnosticStatus::WARN, "the unit says nothing; commands are answered 'busy'");
  diagnostics.add("unit", reach.is_unit_here ? "reports" : "silent");
  diagnostics.add("emergency stop", said.is_emergency_stop_pressed != 0 ? "pressed" : "not pressed");
  diagnostics.add("guard", said.is_guard_closed != 0 ? "closed" : "open");
  diagnostics.add("broken frames", reach.broken_frames);
  diagnostics.add("last broken frame", reach.last_break);
  diagnostics.add("last refusal", reach.last_refusal);
}

}  // namespace lamina
