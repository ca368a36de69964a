// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lamina/streaming/job/stream_job.hpp"
#include "streaming/upload/line_at_byte.hpp"
#include "streaming/upload/print_server.hpp"

namespace lamina {

/// Accounts for a print in the status of its job, by what is sent and what the machine reports: lines,
/// complaints, stalls.
class PrintAccount {
 public:
  PrintAccount(StreamStatus& status, const ProgramBody& body);
  PrintAccount(const PrintAccount&) = delete;  // it refers to the status of its job
  PrintAccount& operator=(const PrintAccount&) = delete;

  /// States how many bytes of the program were sent.
  void sent(std::uint64_t bytes);
  /// Reads the machine's messages since the last call, before the print can have begun.
  void hear(PrintServer& server);
  /// Reads the machine's messages since the last call, once the print may have begun. Complaints are counted,
  /// as over a link.
  void hearOfPrint(PrintServer& server);

 private:
  void hearOfMachine(const MachineReport& report);

  StreamStatus& status_;
  LineAtByte sent_line_;
  LineAtByte read_line_;
  std::string doubt_;                           ///< of the last report
  std::optional<std::uint64_t> stalls_before_;  ///< number before the print
};

}  // namespace lamina
