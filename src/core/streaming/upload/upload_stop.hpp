// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

#include "lamina/streaming/job/stream_settings.hpp"
#include "streaming/upload/print_server.hpp"

namespace lamina {

/// The safe stop of a print on a server: what to ask for next, by the reports of the machine, and when the
/// stop is confirmed, or to be given up.
class UploadStop {
 public:
  /// What follows from a report; nothing if the next one is to be waited for.
  struct Verdict {
    std::optional<UploadStep> next;           ///< to be asked for
    std::optional<std::string> confirmation;  ///< how the stop has ended, for the end of a message
  };

  explicit UploadStop(const StreamSettings& settings) : settings_(settings) {}

  void begin(double now) { until_s_ = now + settings_.safe_stop_timeout_s; }
  /// When to give up.
  double until() const { return until_s_; }

  /// States that the machine has said that it prints the print.
  void seen() { was_seen_ = true; }
  /// States that the file of the print was removed, or is refused to be.
  void removed() { is_removed_ = true; }
  bool isRemoved() const { return is_removed_; }

  /// Takes a report.
  /// @param told  the message so far
  Verdict judge(const PrintServer& server, const std::string& told, double now);

  /// States that heaters are asked to go off.
  void heatersAsked(double now) { heaters_asked_s_ = now; }
  /// States that a step was not done.
  void notDone(UploadStep step);
  void emergencyStopTaken();
  /// @param answer  to an emergency stop that is not known to be taken, in words
  void emergencyStopAnswered(const std::string& answer) { emergency_.answer = answer; }
  /// Whether to ask for an emergency stop, again if it may be done: a repeated one does no harm.
  bool isEmergencyStopDue() const { return emergency_.is_asked && !emergency_.is_taken; }

  /// Decides, when the stop is to be given up, to ask for an emergency stop first.
  /// @return whether it is
  bool takeEmergencyStop(const PrintServer& server, double now);
  /// What was not confirmed, for the end of a message.
  std::string remark(const PrintServer& server) const;

 private:
  struct AskedEmergencyStop {
    bool is_asked = false;
    bool is_taken = false;             ///< the server has said so
    std::string answer = "no answer";  ///< to the last request, in words
  };

  Verdict cancel(PrintState print, double now);
  Verdict awaitStandstill(const MachineReport& report, const std::string& how, double now) const;

  StreamSettings settings_;
  double until_s_ = 0.0;
  bool was_seen_ = false;
  bool is_removed_ = false;
  std::optional<double> heaters_asked_s_;
  std::array<int, 2> cancels_{};  ///< asked for while it printed, and while it was paused
  AskedEmergencyStop emergency_;
};

}  // namespace lamina
