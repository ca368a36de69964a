// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "lamina/startup/machine_reports.hpp"
#include "lamina/startup/startup_sequence.hpp"
#include "lamina/streaming/job/firmware_reply.hpp"

namespace lamina {

/// A condition that the start-up has established and that a job needs until its end.
enum class KeptCondition : std::uint8_t { Bed, Vacuum, Homing, Dryness };

/// The loss of a condition that the program itself has not ended.
struct JobLoss {
  KeptCondition what = KeptCondition::Bed;
  std::string reason;  ///< in words, with actual value, unit and expected value
  double value = 0.0;  ///< actual value [degC, kPa]; 0 if there is none
};

/// Whether the lines that are sent are known.
enum class WatchedLines : std::uint8_t {
  OfTheProgram,   ///< the lines of the program, unchanged
  MayBeReplaced,  ///< lines that may replace those of the program and are not known here
};

/// Watches during a job whether the machine keeps what its start-up has established: temperature of the bed,
/// vacuum and homing (dryness is left to `StartupSession`). Only results of steps in the sequence are
/// watched, from the machine's reports; conditions that the machine does not report are not judged. Inputs
/// are commands of the program, replies and times. Times are machine times [s] and never go back.
///
/// A condition that the program itself ends is no loss. If the program sets another bed target, the bed is
/// watched again once the new target is first reached; with the target 0 it is no longer watched. Axes whose
/// motors the program switches off, and zones that it closes, are no longer watched. If lines may be
/// replaced, only the bed is watched, and any change of its target counts as the program's.
class JobWatch {
 public:
  /// Begins to watch; every step of the sequence must be done.
  JobWatch(const StartupSettings& settings, WatchedLines lines);

  /// States that a command of the program was sent.
  void onSent(const std::string& command);
  /// States that the machine has sent a line.
  void onReply(const FirmwareReply& reply, double now_s);

  /// The present losses, in the order of `KeptCondition`. A loss ends as soon as the machine reports the
  /// expected value.
  std::vector<JobLoss> losses() const;

 private:
  /// A target of the bed that the program has not set.
  struct ForeignTarget {
    double target_c = 0.0;
    double since_s = 0.0;
    bool is_believed = false;  ///< whether it has lasted long enough to be no error of transmission
  };
  void followTarget(const ReportedTemperatures& temperatures, double now_s);
  void followBed(double bed_c, double now_s);
  void release(const std::string& command);
  std::optional<JobLoss> bedLoss() const;
  std::optional<JobLoss> vacuumLoss() const;
  std::optional<JobLoss> homingLoss() const;

  StartupSettings settings_;
  MachineReports reports_;
  std::vector<std::string> vacuum_off_;
  std::string axes_;  ///< axes homed by the sequence whose motors the program has not switched off
  bool watches_bed_ = false;
  bool watches_vacuum_ = false;
  bool is_opaque_ = false;       ///< whether lines may be replaced, or macros were sent
  double target_c_ = 0.0;        ///< target of the bed by the program, as the machine reports it
  std::deque<double> asked_c_;   ///< targets of the bed that were sent and not yet reported
  double target_since_s_ = 0.0;  ///< time at which `target_c_` was first reported
  bool is_reached_ = true;
  double bed_c_ = 0.0;
  std::optional<ForeignTarget> foreign_;
  std::optional<double> cold_since_s_;
  bool is_cold_ = false;
  bool is_late_ = false;
  std::string unhomed_;  ///< message of the machine that asks for homing; empty for none
};

}  // namespace lamina
