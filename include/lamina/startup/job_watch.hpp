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

/// What a start-up has given a job, and the job needs until its end.
enum class KeptCondition : std::uint8_t { Bed, Vacuum, Homing, Dryness };

/// A condition that is not there any more though the program has not ended it.
struct JobLoss {
  KeptCondition what = KeptCondition::Bed;
  std::string reason;  ///< with actual value, unit and expected
  double value = 0.0;  ///< that was found [degC, kPa]; 0 where there is none
};

/// What is known of the lines that are sent.
enum class WatchedLines : std::uint8_t {
  OfTheProgram,
  MayBeReplaced,  ///< by others, which nobody has read here
};

/// Whether a machine keeps, while a job runs, what its start-up has brought about: the bed's temperature, the
/// vacuum, the homing. Only steps of the sequence are watched, by what the machine reports; what is not
/// reported is not judged. Commands of the program, replies and times come in. Times are machine times [s]
/// and never go back.
///
/// What the program itself ends is no loss: another target of the bed is kept from when it is first reached,
/// none is kept after 0; axes whose motors it switches off and zones that it closes are watched no more. Of
/// lines that may be replaced, any change of the bed's target may be theirs, and only the bed is watched.
class JobWatch {
 public:
  /// Every step of the sequence is done.
  JobWatch(const StartupSettings& settings, WatchedLines lines);

  /// A command of the program has been sent.
  void onSent(const std::string& command);
  void onReply(const FirmwareReply& reply, double now_s);

  /// In the order of the conditions; each is gone as soon as the machine reports what is expected.
  std::vector<JobLoss> losses() const;

 private:
  /// Of the bed, that the program has not set.
  struct ForeignTarget {
    double target_c = 0.0;
    double since_s = 0.0;
    bool is_believed = false;  ///< it lasts
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
  std::string axes_;  ///< of the sequence, which the program has not let go
  bool watches_bed_ = false;
  bool watches_vacuum_ = false;
  bool is_opaque_ = false;       ///< macros were sent, whose commands nobody knows
  double target_c_ = 0.0;        ///< of the bed, that the program asked for and the machine has taken
  std::deque<double> asked_c_;   ///< targets that were sent and not yet reported
  double target_since_s_ = 0.0;  ///< when it was first reported
  bool is_reached_ = true;
  double bed_c_ = 0.0;
  std::optional<ForeignTarget> foreign_;
  std::optional<double> cold_since_s_;
  bool is_cold_ = false;
  bool is_late_ = false;
  std::string unhomed_;  ///< the machine's own words
};

}  // namespace lamina
