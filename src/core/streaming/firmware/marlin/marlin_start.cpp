// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// From who is there to the first line.
#include <utility>

#include "streaming/firmware/marlin/marlin_job.hpp"

namespace lamina {

void MarlinJob::start(double now) {
  if (record_.status.state != PackmlState::Idle) return;
  record_.enter(PackmlState::Starting);
  if (enquiry_) {
    beginPhase(Phase::Enquiring, now);
    enquiry_->start(now);
    return followEnquiry(now);
  }
  if (!firmware_name_) return identify(now);
  record_.status.firmware_name = *firmware_name_;
  beginNumbering(line_base_, now);
}

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
  answers_due_ = 0;  // the enquiry has waited for them
  nextReport(now);
}

void MarlinJob::beginNumbering(std::uint64_t base, double now) {
  base_ = base;
  beginPhase(Phase::Numbering, now);
  retry(now);
}

/// The firmware refuses a wrong number as soon as it reads it, but says the ok to what it has queued before
/// only when that is done.
void MarlinJob::confirm(double now) {
  settle_until_ = answers_due_ > 0 ? now + settings_.settle_s : 0.0;
  if (!isSettling()) return nextReport(now);
  if (phase_ != Phase::Confirming) beginPhase(Phase::Confirming, now);
}

void MarlinJob::nextReport(double now) {
  if (!reports_.empty()) {
    beginPhase(Phase::Reporting, now);
    ++answers_due_;
    output_ += reports_.back() + "\n";
    return;
  }
  if (isAtRest()) return finishComplete();
  if (answers_due_ > 0) return confirm(now);
  has_begun_ = true;
  record_.enter(PackmlState::Execute);
  beginPhase(Phase::Feeding, now);
  awaitProbes(now);
  proceed(now);
}

void MarlinJob::onReportDone(double now) {
  reports_.pop_back();
  report_attempts_ = 0;
  nextReport(now);
}

}  // namespace lamina
