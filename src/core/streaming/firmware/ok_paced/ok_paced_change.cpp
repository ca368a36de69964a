// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/ok_paced/ok_paced_job.hpp"

namespace lamina {

std::string OkPacedJob::change(const LiveChange& change, double) {
  const PackmlState state = record_.status.state;
  const bool is_running =
      state == PackmlState::Execute || state == PackmlState::Holding || state == PackmlState::Held;
  if (!is_running || phase_ != Phase::Feeding) return kNoJobToChange;
  if (layer_pause_.take(change)) return {};
  const ChangeCommand changed = firmware_->changed(change, checked_program_);
  if (changed.command.empty()) return changed.refusal;
  if (!leavesRoomForStop()) {
    return "the machine waits, and has " + std::to_string(unanswered_.count()) +
           " commands to answer; expected fewer, so that it hears a stop";
  }
  send(changed.command, {});
  return {};
}

}  // namespace lamina
