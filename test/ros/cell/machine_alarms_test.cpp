// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/host_watch/machine_alarms.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

/// "2201! 2204." for one that is raised and one that has gone.
std::string reported(const std::vector<HostAlarm>& alarms) {
  std::string text;
  for (const HostAlarm& alarm : alarms)
    text += (text.empty() ? "" : " ") + std::to_string(alarm.id) + (alarm.is_gone ? '.' : '!');
  return text;
}

TEST(MachineAlarms, AreThoseOfALostStreamerUntilItIsBack) {
  MachineAlarms alarms;
  EXPECT_EQ(reported(alarms.present()), "2201. 2204.");
  const auto lost = alarms.of({GuardNewsKind::Lost, "process 7 has ended"});
  EXPECT_EQ(reported(lost), "2201!");
  EXPECT_EQ(lost[0].message, "process 7 has ended");
  EXPECT_EQ(reported(alarms.present()), "2201! 2204.");
  EXPECT_EQ(reported(alarms.of({GuardNewsKind::Back, ""})), "2201. 2204.");
}

TEST(MachineAlarms, TellOfAMachineThatWasStoppedAndOfOneThatWasNot) {
  MachineAlarms alarms;
  alarms.of({GuardNewsKind::Lost, ""});
  EXPECT_EQ(reported(alarms.of({GuardNewsKind::NotStopped, "no answer"})), "2204!");
  EXPECT_EQ(reported(alarms.present()), "2201! 2204!");
  const auto stopped = alarms.of({GuardNewsKind::Stopped, "at rest"});
  EXPECT_EQ(reported(stopped), "2203! 2201. 2204.");
  EXPECT_EQ(stopped[0].message, "at rest");
  EXPECT_EQ(reported(alarms.present()), "2201. 2204.") << "2203 is an event";
}

}  // namespace
}  // namespace lamina
