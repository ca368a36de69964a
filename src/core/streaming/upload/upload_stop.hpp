// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

#include "lamina/streaming/job/stream_settings.hpp"
#include "streaming/upload/print_server.hpp"

namespace lamina {

/// The safe stop of a print on a server: what to request next, according to the machine's reports, and when
/// the stop is confirmed or to be given up.
class UploadStop {
 public:
  /// What follows from a report; both empty if the next report is to be awaited.
  struct Verdict {
    std::optional<UploadStep> next;           ///< step to be requested
    std::optional<std::string> confirmation;  ///< how the stop has ended, for the end of a message
  };

  explicit UploadStop(const StreamSettings& settings) : settings_(settings) {}

  void begin(double now) { until_s_ = now + settings_.safe_stop_timeout_s; }
  /// Time at which to give up.
  double until() const { return until_s_; }

  /// States that the machine has reported that it prints the file.
  void seen() { was_seen_ = true; }
  /// States that the file of the print was removed, or that the server refuses to remove it.
  void removed() { is_removed_ = true; }
  bool isRemoved() const { return is_removed_; }

  /// Evaluates a report.
  /// @param told  the message so far
  Verdict judge(const PrintServer& server, const std::string& told, double now);

  /// States that switching off the heaters was requested.
  void heatersAsked(double now) { heaters_asked_s_ = now; }
  /// States that a step was not done.
  void notDone(UploadStep step);
  void emergencyStopTaken();
  /// Sets the answer to the emergency stop, for a message.
  /// @param answer  to a request that the server may not have accepted, in words
  void emergencyStopAnswered(const std::string& answer) { emergency_.answer = answer; }
  /// Whether to request an emergency stop; it may be requested again, as repeating it does no harm.
  bool isEmergencyStopDue() const { return emergency_.is_asked && !emergency_.is_taken; }

  /// Whether to request an emergency stop first, now that the stop is to be given up.
  /// @return whether one is requested
  bool takeEmergencyStop(const PrintServer& server, double now);
  /// What was not confirmed, for the end of a message.
  std::string remark(const PrintServer& server) const;

 private:
  struct AskedEmergencyStop {
    bool is_asked = false;
    bool is_taken = false;             ///< whether the server has confirmed it
    std::string answer = "no answer";  ///< to the last request, in words
  };

  Verdict cancel(PrintState print, double now);
  Verdict awaitStandstill(const MachineReport& report, const std::string& how, double now) const;

  StreamSettings settings_;
  double until_s_ = 0.0;
  bool was_seen_ = false;
  bool is_removed_ = false;
  std::optional<double> heaters_asked_s_;
  std::array<int, 2> cancels_{};  ///< number of cancellations requested while printing, and while paused
  AskedEmergencyStop emergency_;
};

}  // namespace lamina
