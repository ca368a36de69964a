// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// How a job is gone on with, and changed, from outside.
#include <utility>

#include "streaming/firmware/marlin/marlin_job.hpp"

namespace lamina {

void MarlinJob::hearEnquiry(const FirmwareReply& reply, double now) {
  enquiry_->hear(reply, now);
  followEnquiry(now);
}

void MarlinJob::followEnquiry(double now) {
  output_ += enquiry_->takeOutput();
  if (enquiry_->failure().code != ErrorCode::Ok) {
    abort(enquiry_->failure(), now);
  } else if (enquiry_->taken()) {
    goOnAfter(*enquiry_->taken(), now);
  }
}

/// The firmware counts on from where it is: its number is what proves that no line is lost or run twice.
void MarlinJob::goOnAfter(std::uint64_t number, double now) {
  StreamStatus& status = record_.status;
  status.lines_sent = status.lines_acknowledged = number - line_base_;
  const auto pass = [&](const ProgramLine& line) {
    outputs_.see(line.command);
    status.layer = line.layer;
  };
  auto rest = restOf(program_, status.lines_acknowledged, pass);
  feed_ = LineFeed(std::move(rest), number + 1, status.layer);
  proof_.asked(number + 1);
  nextReport(now);
}

bool MarlinJob::change(const LiveChange& change, double now) {
  const PackmlState state = record_.status.state;
  if (state != PackmlState::Execute && state != PackmlState::Holding && state != PackmlState::Held)
    return false;
  if (change.setting == LiveSetting::PauseAtLayer) {
    layer_pause_.set(change.value);
    return true;
  }
  const auto command = firmware_->changed(change);
  if (!command) return false;
  changes_.push_back(*command);
  if (phase_ == Phase::Feeding) proceed(now);
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
