// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/streaming/job/stream_settings.hpp"
#include "streaming/firmware/grbl/grbl_machine.hpp"

namespace lamina {

/// Prepares a machine for a job: waits until it is idle, unlocks it if the settings say so, and identifies
/// it. Nothing else is changed in the machine.
class GrblStart {
 public:
  explicit GrblStart(const StreamSettings& settings) : settings_(settings) {}

  void begin(double now);
  void hear(const GrblReply& reply, double now);
  void elapse(double now);
  double nextDeadline() const;
  std::string takeOutput();

  bool isReady() const { return step_ == Step::Ready; }
  /// The machine, complete when ready.
  const GrblMachine& machine() const { return machine_; }
  /// Why the job is refused, if it is.
  const std::optional<Failure>& failure() const { return failure_; }

 private:
  enum class Step {
    Awaiting,   ///< that the machine is idle
    Unlocking,  ///< the ok to `$X`
    Asking,     ///< the answers to `$I`, `$G` and `$$`
    Ready,
  };

  void onReport(const GrblReport& report);
  void onLocked(const GrblReport& report);
  void ask(std::size_t question);
  void onAnswer(const GrblReply& reply);
  void refuse(const std::string& why) { failure_ = Failure{ErrorCode::Rejected, why}; }
  void timeOut();

  StreamSettings settings_;
  Step step_ = Step::Awaiting;
  GrblMachine machine_;
  std::optional<Failure> failure_;
  double began_s_ = 0.0;
  double next_poll_s_ = 0.0;
  bool has_reported_ = false;
  std::string last_state_;
  int idle_reports_ = 0;
  int alarm_code_ = 0;  ///< 0 if no code was received
  bool has_unlocked_ = false;
  std::size_t question_ = 0;
  bool is_answered_ = false;  ///< whether the question was answered, except for its ok
  std::string output_;
};

}  // namespace lamina
