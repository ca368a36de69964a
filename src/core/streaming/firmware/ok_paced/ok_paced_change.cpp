// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/ok_paced/ok_paced_job.hpp"

namespace lamina {

std::string OkPacedJob::change(const LiveChange& change, double) {
  const PackmlState state = record_.status.state;
  const bool is_running =
      state == PackmlState::Execute || state == PackmlState::Holding || state == PackmlState::Held;
  if (!is_running || phase_ != Phase::Feeding) return kNoJobToChange;
  if (change.setting == LiveSetting::PauseAtLayer) {
    layer_pause_.set(change.value);
    return {};
  }
  const ChangeCommand changed = firmware_->changed(change, checked_program_);
  if (!changed.command.empty()) send(changed.command, {});
  return changed.refusal;
}

}  // namespace lamina
