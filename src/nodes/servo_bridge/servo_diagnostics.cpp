// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "servo_diagnostics.hpp"

namespace lamina {

void fillDiagnostics(const ServojDriveState& state, const std::string& connection, const std::string& rights,
                     diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  using diagnostic_msgs::DiagnosticStatus;
  diagnostics.summary(DiagnosticStatus::OK, state.is_at_rest ? "connected, at rest" : "connected, moving");
  if (!state.is_connected)
    diagnostics.summary(DiagnosticStatus::ERROR,
                        "no robot: " + (connection.empty() ? "it has not reported yet" : connection));
  if (!state.fault.empty())
    diagnostics.mergeSummary(DiagnosticStatus::ERROR, "the last motion has ended early: " + state.fault);
  diagnostics.add("connected", state.is_connected ? "yes" : "no");
  diagnostics.add("at rest", state.is_at_rest ? "yes" : "no");
  diagnostics.add("last fault", state.fault);
  diagnostics.add("cycles run", rights);
}

}  // namespace lamina
