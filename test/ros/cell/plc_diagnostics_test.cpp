// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/plc_link/plc_diagnostics.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace lamina {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using Said = lamina_msgs::PlcInputs;

DiagnosticStatus diagnosticsOf(std::uint8_t watchdog, const PlcReach& reach) {
  Said said;
  said.watchdog = watchdog;
  diagnostic_updater::DiagnosticStatusWrapper diagnostics;
  fillDiagnostics(said, reach, diagnostics);
  return diagnostics;
}

TEST(PlcDiagnostics, FollowTheHeartbeat) {
  const PlcReach here{true, "", "", 0};
  EXPECT_EQ(diagnosticsOf(Said::GOOD, here).level, DiagnosticStatus::OK);
  EXPECT_EQ(diagnosticsOf(Said::UNARMED, here).level, DiagnosticStatus::WARN);
  EXPECT_EQ(diagnosticsOf(Said::LOST, here).level, DiagnosticStatus::ERROR);
  EXPECT_EQ(diagnosticsOf(Said::ABANDONED, here).level, DiagnosticStatus::ERROR);
}

TEST(PlcDiagnostics, NameASilentUnitAndWhatWasRefused) {
  const DiagnosticStatus status = diagnosticsOf(Said::GOOD, {false, "Start: a guard is open", "a", 3});
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_NE(status.message.find("the unit says nothing"), std::string::npos) << status.message;
  std::map<std::string, std::string> values;
  for (const auto& value : status.values) values[value.key] = value.value;
  EXPECT_EQ(values["last refusal"], "Start: a guard is open");
  EXPECT_EQ(values["broken frames"], "3");
}

}  // namespace
}  // namespace lamina
