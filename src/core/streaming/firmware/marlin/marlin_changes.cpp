// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What a person changes while a job runs.
#include "streaming/firmware/marlin/marlin_job.hpp"

namespace lamina {

std::string MarlinJob::change(const LiveChange& change, double now) {
  const PackmlState state = record_.status.state;
  if (state != PackmlState::Execute && state != PackmlState::Holding && state != PackmlState::Held)
    return kNoJobToChange;
  if (change.setting == LiveSetting::PauseAtLayer) {
    layer_pause_.set(change.value);
    return {};
  }
  const auto command = firmware_->changed(change);
  if (!command) return notOf("this firmware", change.setting);
  changes_.push_back(*command);
  if (phase_ == Phase::Feeding) proceed(now);
  return {};
}

/// Questions wait for nobody: more than a few would stop the lines.
bool MarlinJob::ask(const std::string& command, double now) {
  constexpr std::size_t kMostWaiting = 16;
  const PackmlState state = record_.status.state;
  const bool is_running =
      state == PackmlState::Execute || state == PackmlState::Holding || state == PackmlState::Held;
  if (!is_running || changes_.size() >= kMostWaiting) return false;
  changes_.push_back(command);
  if (phase_ == Phase::Feeding) proceed(now);
  return true;
}

/// What becomes of a layer may depend on all that is below it: its time counts from when the machine is at
/// rest.
/// @return whether the lines of a layer wait
bool MarlinJob::awaitLayer(double now) {
  constexpr double kLookInterval = 0.01;  // s
  if (isStopping() || feed_.isNextKnown()) return false;
  starvation_.standStill();
  if (!is_rest_asked_) {
    is_rest_asked_ = true;
    changes_.push_back(firmware_->endOfMotions());
    return beginChange(now);
  }
  if (layer_due_ == 0.0) layer_due_ = now + revised_->waitTime();
  next_look_ = now + kLookInterval;
  return true;
}

/// A change has no number, so that the numbers stay those of the program's lines: it goes out while no line
/// is under way.
/// @return whether lines must wait
bool MarlinJob::beginChange(double now) {
  if (changes_.empty() || isStopping()) return false;
  if (!sent_.empty() || unanswered_probes_ > 0) return !sent_.empty();
  beginPhase(Phase::Changing, now);
  output_ += changes_.front() + "\n";
  return true;
}

}  // namespace lamina
