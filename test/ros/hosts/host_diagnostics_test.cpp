// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/host_watch/host_diagnostics.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace lamina {
namespace {

using diagnostic_msgs::DiagnosticStatus;

lamina_msgs::HostState watched() {
  lamina_msgs::HostState host;
  host.has_master = 1;
  host.free_space = 3.0 * 1024.0 * 1024.0 * 1024.0;
  lamina_msgs::HostPeer peer;
  peer.name = "sensing";
  peer.is_compared = 1;
  peer.clock_offset = 0.002;
  host.peers = {peer};
  lamina_msgs::HostNode node;
  node.name = "/gcode_streamer";
  node.answers = 1;
  node.restarts = 2;
  host.nodes = {node};
  return host;
}

DiagnosticStatus diagnosticsOf(const lamina_msgs::HostState& host, const std::vector<HostAlarm>& alarms) {
  diagnostic_updater::DiagnosticStatusWrapper diagnostics;
  fillDiagnostics(host, alarms, diagnostics);
  return diagnostics;
}

TEST(HostDiagnostics, ShowWhatIsWatched) {
  const DiagnosticStatus status = diagnosticsOf(watched(), {});
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  std::map<std::string, std::string> values;
  for (const auto& value : status.values) values[value.key] = value.value;
  EXPECT_EQ(values["free space [GiB]"], "3");
  EXPECT_EQ(values["ROS master"], "answers");
  EXPECT_EQ(values["host sensing"], "heard, its clock ahead by 0.002 s");
  EXPECT_EQ(values["node /gcode_streamer"], "answers, restarted 2 times");
}

TEST(HostDiagnostics, WarnOfAlarmsAndFailWithoutWhatIsNeeded) {
  const HostAlarm disk{7002, 1.0, "1 GiB is free"};
  lamina_msgs::HostState host = watched();
  EXPECT_EQ(diagnosticsOf(host, {disk}).level, DiagnosticStatus::WARN);
  EXPECT_EQ(diagnosticsOf(host, {disk}).message, "7002: 1 GiB is free");
  const HostAlarm lost{8001, 2.5, "sensing is silent for 2.5 s"};
  host.peers[0].is_lost = 1;
  EXPECT_EQ(diagnosticsOf(host, {lost}).level, DiagnosticStatus::WARN) << "it is not needed";
  host.peers[0].is_needed = 1;
  EXPECT_EQ(diagnosticsOf(host, {lost}).level, DiagnosticStatus::ERROR);
  host = watched();
  host.has_master = 0;
  EXPECT_EQ(diagnosticsOf(host, {{8002, 5.0, "the ROS master does not answer"}}).level,
            DiagnosticStatus::ERROR);
}

}  // namespace
}  // namespace lamina
