// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/print_verdict.hpp"

namespace lamina {
namespace {

std::string named(const MachineReport& report) { return "\"" + report.file + "\""; }

Failure shutDown(const MachineReport& report) {
  return {ErrorCode::DeviceError, "the printer has shut itself down: " + report.condition};
}

Failure cancelled(const std::string& remark) {
  return {ErrorCode::Cancelled, "the print was cancelled at the machine" + remark};
}

Failure failed(const MachineReport& report, const std::string& remark) {
  return {ErrorCode::Rejected, "the print has ended with an error: " + report.condition + remark};
}

}  // namespace

std::optional<Failure> hindrance(const MachineReport& report) {
  if (!report.is_ready) return Failure{ErrorCode::Rejected, "the printer is not ready: " + report.condition};
  if (!report.isPrintUnderWay()) return std::nullopt;
  return Failure{ErrorCode::Rejected,
                 "the printer has another print under way, " + named(report) + "; expected it to have none"};
}

std::optional<Failure> hindranceToGoOn(const MachineReport& report, const std::string& earlier_files) {
  const bool is_known =
      report.state != PrintState::None && report.file.compare(0, earlier_files.size(), earlier_files) == 0;
  if (!is_known) {
    const std::string last =
        report.file.empty() ? "it knows of no print" : "its last print is " + named(report);
    return Failure{ErrorCode::Rejected,
                   "there is no print of this program to go on with: " + last + "; expected " +
                       earlier_files + "... (a machine that was restarted has lost it, and its position)"};
  }
  // What has ended leaves the machine to others, who may have heated it since.
  constexpr const char* kLeftAlone = "; its heaters and its file were left as they are";
  if (report.state == PrintState::Stopped) return cancelled(kLeftAlone);
  if (report.state == PrintState::Failed) return failed(report, kLeftAlone);
  return std::nullopt;
}

std::optional<Failure> hindranceToCome(const MachineReport& report) {
  if (report.is_halted) return shutDown(report);
  if (!report.isPrintUnderWay()) return std::nullopt;
  return Failure{ErrorCode::Rejected, "another print, " + named(report) + ", was started before this one"};
}

std::optional<Failure> endOfPrint(const PrintServer& server) {
  const MachineReport& report = server.report();
  if (report.is_halted) return shutDown(report);
  if (!server.isOurs() && !report.file.empty())
    return Failure{ErrorCode::Cancelled, "another print, " + named(report) + ", was started at the machine"};
  if (!server.isOurs())
    return Failure{ErrorCode::DeviceError,
                   "the machine no longer knows of the print: it was restarted, or the print was cleared"};
  switch (report.state) {
    case PrintState::None:
      return Failure{ErrorCode::DeviceError, "the machine no longer knows how the print stands"};
    case PrintState::Stopped:
      return cancelled("");
    case PrintState::Failed:
      return failed(report, "");
    default:
      return std::nullopt;
  }
}

}  // namespace lamina
