// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host_diagnostics.hpp"

#include <algorithm>
#include <string>

#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr double kGibibyteOfDisk = 1024.0 * 1024.0 * 1024.0;

bool isGrave(const lamina_msgs::HostState& host) {
  return host.has_master == 0 ||
         std::any_of(host.peers.begin(), host.peers.end(), [](const lamina_msgs::HostPeer& peer) {
           return peer.is_needed != 0 && peer.is_lost != 0;
         });
}

std::string textOf(const lamina_msgs::HostPeer& peer) {
  if (peer.is_lost != 0) return "lost, silent for " + numberText(peer.silent) + " s";
  if (peer.is_compared == 0) return "heard, its clock not compared yet";
  return "heard, its clock ahead by " + numberText(peer.clock_offset) + " s";
}

std::string textOf(const lamina_msgs::HostNode& node) {
  return std::string(node.answers != 0 ? "answers" : "does not answer") + ", restarted " +
         std::to_string(node.restarts) + " times";
}

}  // namespace

void fillDiagnostics(const lamina_msgs::HostState& host, const std::vector<HostAlarm>& alarms,
                     diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  diagnostics.summary(DiagnosticStatus::OK, "watching");
  for (const HostAlarm& alarm : alarms)
    diagnostics.mergeSummary(isGrave(host) ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN,
                             std::to_string(alarm.id) + ": " + alarm.message);
  diagnostics.add("ROS master", host.master_defect.empty() ? "answers" : host.master_defect);
  diagnostics.add("free space [GiB]", host.free_space / kGibibyteOfDisk);
  for (const lamina_msgs::HostPeer& peer : host.peers) diagnostics.add("host " + peer.name, textOf(peer));
  for (const lamina_msgs::HostNode& node : host.nodes) diagnostics.add("node " + node.name, textOf(node));
}

}  // namespace lamina
