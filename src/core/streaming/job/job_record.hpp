// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lamina/streaming/job/stream_job.hpp"

namespace lamina {

/// The status of a job, and the states that it has entered.
class JobRecord {
 public:
  StreamStatus status;

  void enter(PackmlState state) {
    status.state = state;
    entered_.push_back(state);
  }
  std::vector<PackmlState> takeStateChanges() { return std::exchange(entered_, {}); }

  void beginToStop(const Failure& why) {
    status.failure = why;
    enter(PackmlState::Aborting);
  }

  bool isStarting() const { return status.state == PackmlState::Starting; }
  bool isStopping() const { return status.state == PackmlState::Aborting; }
  /// Whether lines are under way, or held back by a pause.
  bool isUnderWay() const { return status.state == PackmlState::Execute || isPaused(); }
  /// Whether the job holds, or is about to hold.
  bool isPaused() const { return status.state == PackmlState::Holding || status.state == PackmlState::Held; }
  /// Ends a pause of a machine that accepts lines again at once.
  void goOn() {
    if (status.state == PackmlState::Holding) enter(PackmlState::Held);
    enter(PackmlState::Unholding);
    enter(PackmlState::Execute);
  }

  /// Position in the program, for the end of a message: "; line 3 of 9 was the last acknowledged".
  std::string whereItStands() const {
    return "; line " + std::to_string(status.lines_acknowledged) + " of " +
           std::to_string(status.lines_total) + " was the last acknowledged";
  }

 private:
  std::vector<PackmlState> entered_;
};

}  // namespace lamina
