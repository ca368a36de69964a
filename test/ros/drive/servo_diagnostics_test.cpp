// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/servo_bridge/servo_diagnostics.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

using diagnostic_msgs::DiagnosticStatus;

DiagnosticStatus diagnosticsOf(const ServojDriveState& state, const std::string& connection) {
  diagnostic_updater::DiagnosticStatusWrapper diagnostics;
  fillDiagnostics(state, connection, "in real time", diagnostics);
  return diagnostics;
}

TEST(ServoDiagnostics, AreOkWhileTheRobotIsConnected) {
  ServojDriveState state;
  state.is_connected = true;
  EXPECT_EQ(diagnosticsOf(state, "").level, DiagnosticStatus::OK);
  state.is_at_rest = false;
  EXPECT_EQ(diagnosticsOf(state, "").message, "connected, moving");
}

TEST(ServoDiagnostics, SayWhyThereIsNoRobotAndWhyAMotionHasEnded) {
  ServojDriveState state;
  DiagnosticStatus status = diagnosticsOf(state, "192.0.2.7:30002 does not answer");
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_EQ(status.message, "no robot: 192.0.2.7:30002 does not answer");
  state.is_connected = true;
  state.fault = "a cycle came 12 ms late";
  status = diagnosticsOf(state, "");
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_NE(status.message.find("a cycle came 12 ms late"), std::string::npos) << status.message;
}

}  // namespace
}  // namespace lamina
