// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/cell_controller/unit_diagnostics.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace lamina {
namespace {

using diagnostic_msgs::DiagnosticStatus;

lamina_msgs::CellAlarm alarm(std::uint16_t id, const std::string& category, const std::string& message) {
  lamina_msgs::CellAlarm alarm;
  alarm.id = id;
  alarm.category = category;
  alarm.message = message;
  return alarm;
}

DiagnosticStatus diagnosticsOf(const std::vector<lamina_msgs::CellAlarm>& active) {
  lamina_msgs::PackmlStatus unit;
  unit.state_name = "Held";
  unit.job.id = 7;
  lamina_msgs::CellAlarms alarms;
  alarms.alarms = active;
  diagnostic_updater::DiagnosticStatusWrapper diagnostics;
  fillDiagnostics(unit, alarms, diagnostics);
  return diagnostics;
}

TEST(UnitDiagnostics, AreOkWithoutAlarms) {
  const DiagnosticStatus status = diagnosticsOf({alarm(9002, "I", "it listens")});
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "Held");
  std::map<std::string, std::string> values;
  for (const auto& value : status.values) values[value.key] = value.value;
  EXPECT_EQ(values["state"], "Held");
  EXPECT_EQ(values["job"], "7");
  EXPECT_EQ(values["active alarms"], "1");
}

TEST(UnitDiagnostics, AreAsGraveAsTheGravestAlarm) {
  DiagnosticStatus status = diagnosticsOf({alarm(2102, "W", "refused")});
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_EQ(status.message, "2102: refused");
  status = diagnosticsOf({alarm(2102, "W", "refused"), alarm(2201, "A", "the executor is lost")});
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_NE(status.message.find("2201: the executor is lost"), std::string::npos) << status.message;
}

TEST(UnitDiagnostics, WarnOfAnAlarmThatWaitsToBeAcknowledged) {
  lamina_msgs::CellAlarm gone = alarm(2201, "A", "the executor is lost");
  gone.is_gone = 1;
  EXPECT_EQ(diagnosticsOf({gone}).level, DiagnosticStatus::WARN);
}

}  // namespace
}  // namespace lamina
