// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/print_account.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace lamina {

PrintAccount::PrintAccount(StreamStatus& status, const ProgramBody& body)
    : status_(status), sent_line_(body.commandEnds()), read_line_(body.commandEnds()) {
  status_.lines_total = body.program().lines();
  status_.starvation.source = StarvationSource::Nobody;
}

void PrintAccount::sent(std::uint64_t bytes) {
  status_.lines_sent = std::max(status_.lines_sent, sent_line_.linesBefore(bytes));
}

void PrintAccount::hearOfMachine(const MachineReport& report) {
  if (report.temperatures) status_.temperatures = report.temperatures;
  if (report.position) status_.position = report.position;
  if (report.stalls) status_.starvation.source = StarvationSource::Machine;
  // Told once, not with each report.
  if (report.doubt != std::exchange(doubt_, report.doubt) && !report.doubt.empty())
    status_.message = "left out of the machine's report: " + report.doubt;
}

void PrintAccount::hear(PrintServer& server) {
  const MachineReport& report = server.report();
  hearOfMachine(report);
  server.takeComplaints();
  if (report.stalls) stalls_before_ = report.stalls;
}

void PrintAccount::hearOfPrint(PrintServer& server) {
  const MachineReport& report = server.report();
  hearOfMachine(report);
  if (server.isOurs() && report.state != PrintState::None && report.bytes_read) {
    status_.lines_acknowledged =
        std::max(status_.lines_acknowledged, read_line_.linesBefore(*report.bytes_read));
    status_.layer = read_line_.layer();
  }
  for (const std::string& complaint : server.takeComplaints()) {
    status_.message = complaint;
    if (++status_.commands_not_done == 1) status_.first_not_done = complaint;
  }
  // A machine that was restarted counts anew.
  if (!stalls_before_) stalls_before_ = report.stalls;
  if (report.stalls && *report.stalls > *stalls_before_)
    status_.starvation.count = *report.stalls - *stalls_before_;
}

}  // namespace lamina
