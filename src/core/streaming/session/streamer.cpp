// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/session/streamer.hpp"

#include <exception>
#include <utility>

#include "lamina/base/error.hpp"
#include "streaming/session/identification.hpp"

namespace lamina {

Streamer::Streamer(const StreamableProgram& program, const StreamSettings& settings, ReplyListener heard)
    : Streamer(StreamOrder{program, settings, std::move(heard), {}, 0, {}}) {}

namespace {

/// Why lines cannot be corrected on their way to that firmware; empty if they can, or need not.
std::string defectOfRevision(const StreamOrder& order, const std::string& protocol) {
  if (!order.revision || firmwareProtocols().find(protocol)->canRevise()) return {};
  return "lines cannot be corrected on their way to firmware that speaks " + protocol +
         "; expected marlin, klipper or reprapfirmware";
}

}  // namespace

Streamer::Streamer(StreamOrder order) : order_(std::move(order)) {
  requireConsistent(order_.settings);
  const std::string& firmware = order_.settings.firmware;
  const bool is_any = firmware == kAnyFirmware;
  if (order_.unfinished && (is_any || !firmwareProtocols().find(firmware)->canResume()))
    throw InvalidConfig("stream.firmware is " + firmware +
                        ", with which a job cannot go on on a live machine");
  if (is_any) {
    identification_ = std::make_unique<Identification>(order_);
  } else {
    const std::string defect = order_.program.defectFor(firmware);
    if (!defect.empty()) throw InvalidProgram(defect);
    const std::string unrevised = defectOfRevision(order_, firmware);
    if (!unrevised.empty()) throw InvalidConfig(unrevised);
    job_ = firmwareProtocols().find(firmware)->begin(order_);
  }
}
Streamer::~Streamer() = default;

/// Goes on with the machine that was found.
void Streamer::adopt(double now) {
  if (job_ || !identification_->found()) return;
  const std::string defect = order_.program.defectFor(identification_->found()->protocol);
  if (!defect.empty()) return identification_->abort({ErrorCode::InvalidProgram, defect});
  const std::string unrevised = defectOfRevision(order_, identification_->found()->protocol);
  if (!unrevised.empty()) return identification_->abort({ErrorCode::InvalidConfig, unrevised});
  order_.settings.firmware = identification_->found()->protocol;
  order_.firmware_name = identification_->found()->firmware_name;
  order_.hears_at_once = identification_->found()->hears_at_once;
  order_.answers_due = identification_->answersDue();
  try {
    job_ = firmwareProtocols().find(order_.settings.firmware)->begin(order_);
  } catch (const std::exception&) {
    // The program may be gone by now; the thread of the session has nobody who would catch this.
    return identification_->abort(currentFailure());
  }
  job_->start(now);
  job_->takeStateChanges();  // Starting, which the job is in already
  if (is_hold_due_) job_->pause(now);
  const std::string unread = identification_->takeUnread();
  if (!unread.empty()) job_->receive(unread, now);
}

void Streamer::start(double now) {
  if (job_) return job_->start(now);
  identification_->start(now);
}

void Streamer::receive(std::string_view bytes, double now) {
  if (job_) return job_->receive(bytes, now);
  identification_->receive(bytes, now);
  adopt(now);
}

void Streamer::elapse(double now) {
  if (job_) return job_->elapse(now);
  identification_->elapse(now);
}

void Streamer::disconnect(const std::string& why, double now) {
  if (job_) return job_->disconnect(why, now);
  identification_->abort({ErrorCode::Disconnected, why});
}

void Streamer::reconnect(double now) {
  if (job_) job_->reconnect(now);
}

bool Streamer::isOffline() const { return job_ && job_->isOffline(); }
bool Streamer::pause(double now) {
  if (job_) return job_->pause(now);
  is_hold_due_ = status().state == PackmlState::Starting;
  return is_hold_due_;
}

bool Streamer::resume(double now) {
  if (job_) return job_->resume(now);
  return std::exchange(is_hold_due_, false);
}

std::string Streamer::change(const LiveChange& change, double now) {
  return job_ ? job_->change(change, now) : kNoJobToChange;
}

bool Streamer::ask(const std::string& command, double now) { return job_ && job_->ask(command, now); }

void Streamer::abort(const Failure& why, double now) {
  if (job_) return job_->abort(why, now);
  identification_->abort(why);
}

std::string Streamer::takeOutput() {
  std::string output = identification_ ? identification_->takeOutput() : std::string();
  return job_ ? output + job_->takeOutput() : output;
}

double Streamer::nextDeadline() const {
  return job_ ? job_->nextDeadline() : identification_->nextDeadline();
}
const StreamStatus& Streamer::status() const { return job_ ? job_->status() : identification_->status(); }

std::vector<PackmlState> Streamer::takeStateChanges() {
  std::vector<PackmlState> states;
  if (identification_) states = identification_->takeStateChanges();
  if (!job_) return states;
  for (const PackmlState state : job_->takeStateChanges()) states.push_back(state);
  return states;
}

}  // namespace lamina
