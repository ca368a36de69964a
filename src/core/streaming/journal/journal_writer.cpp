// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/journal/journal_writer.hpp"

#include <algorithm>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/streaming/journal/job_journal.hpp"

namespace lamina {
namespace {

constexpr std::uint64_t kLeastAhead = 256;  // lines
constexpr std::uint64_t kUncertainOks = 8;  // an ok does not say what it is for, and noise may make one
constexpr double kAheadTime = 0.2;          // s
constexpr double kMeasuringTime = 0.02;     // s: the faster the rate is known, the fewer waits at the start
constexpr double kAcknowledgementInterval = 0.1;  // s

}  // namespace

JournalWriter::JournalWriter(ProgressFile file, const JobProgress& known, std::uint64_t lines_total)
    : JournalWriter([file = std::make_shared<ProgressFile>(std::move(file))](
                        const JobProgress& progress) { file->write(stampedNow(progress)); },
                    known, lines_total, kLongestWrite) {}

JournalWriter::JournalWriter(Write write, const JobProgress& known, std::uint64_t lines_total,
                             double patience_s)
    : lines_total_(lines_total),
      taken_before_(known.taken_through),
      patience_(patience_s),
      ahead_(kLeastAhead),
      measured_from_(known.taken_through),
      asked_(known),
      shared_(std::make_shared<Shared>()) {
  shared_->write = std::move(write);
  shared_->wanted = known;
  shared_->kept_sent = known.sent_through;
  thread_ = std::thread([shared = shared_] { run(*shared); });
}

JournalWriter::~JournalWriter() {
  std::unique_lock<std::mutex> lock(shared_->mutex);
  shared_->is_over = true;
  shared_->has_changed.notify_all();
  const auto hasEnded = [this] { return shared_->has_ended; };
  const bool has_ended = !is_stuck_ && shared_->has_changed.wait_for(lock, patience_, hasEnded);
  lock.unlock();
  if (has_ended)
    thread_.join();
  else
    thread_.detach();
}

void JournalWriter::run(Shared& shared) {
  writeAll(shared);
  {
    const std::lock_guard<std::mutex> lock(shared.mutex);
    shared.has_ended = true;
  }
  shared.has_changed.notify_all();
}

/// Until the writer is over, or the disk fails.
void JournalWriter::writeAll(Shared& shared) {
  std::unique_lock<std::mutex> lock(shared.mutex);
  while (true) {
    shared.has_changed.wait(lock, [&shared] { return shared.is_outdated || shared.is_over; });
    if (!shared.is_outdated) return;
    shared.is_outdated = false;
    const JobProgress progress = shared.wanted;
    lock.unlock();
    std::string failure;
    try {
      shared.write(progress);
    } catch (const Error& error) {
      failure = error.what();
    }
    lock.lock();
    shared.failure = failure;
    if (failure.empty()) shared.kept_sent = progress.sent_through;
    shared.has_changed.notify_all();
    if (!failure.empty()) return;
  }
}

/// How many lines leave in the time that the file is ahead.
void JournalWriter::measureRate(std::uint64_t sent, double now) {
  const double passed = now - measured_since_;
  if (measured_since_ >= 0.0 && passed < kMeasuringTime) return;
  if (measured_since_ >= 0.0) {
    const double lines = static_cast<double>(sent - std::min(sent, measured_from_));
    ahead_ = std::max(kLeastAhead, static_cast<std::uint64_t>(lines * kAheadTime / passed));
  }
  measured_since_ = now;
  measured_from_ = sent;
}

void JournalWriter::record(const StreamStatus& status, double now) {
  if (has_failed_) return;
  measureRate(status.lines_sent, now);
  JobProgress progress = asked_;
  // Announced anew when half of what was announced has left.
  if (status.lines_sent + ahead_ / 2 > progress.sent_through)
    progress.sent_through =
        std::max(progress.sent_through, std::min(lines_total_, status.lines_sent + ahead_));
  const std::uint64_t uncertain = status.state == PackmlState::Complete ? 0 : kUncertainOks;
  const std::uint64_t acknowledged = std::min(status.lines_acknowledged, progress.sent_through);
  progress.taken_through = std::max(taken_before_, acknowledged - std::min(acknowledged, uncertain));
  progress.layer = status.layer;
  progress.state = status.state;
  const bool is_due = progress.taken_through != asked_.taken_through && now >= next_acknowledgement_;
  if (is_due || progress.sent_through != asked_.sent_through || progress.layer != asked_.layer ||
      progress.state != asked_.state) {
    next_acknowledgement_ = now + kAcknowledgementInterval;
    asked_ = progress;
    {
      const std::lock_guard<std::mutex> lock(shared_->mutex);
      shared_->wanted = progress;
      shared_->is_outdated = true;
    }
    shared_->has_changed.notify_all();
  }
  require(status.lines_sent);
}

void JournalWriter::require(std::uint64_t sent) {
  std::unique_lock<std::mutex> lock(shared_->mutex);
  const auto isAnswered = [&] { return shared_->kept_sent >= sent || !shared_->failure.empty(); };
  is_stuck_ = !shared_->has_changed.wait_for(lock, patience_, isAnswered);
  if (!is_stuck_ && shared_->failure.empty()) return;
  has_failed_ = true;
  if (!is_stuck_) throw FileError(shared_->failure);
  // What is known by then is old when the disk answers.
  shared_->is_outdated = false;
  shared_->is_over = true;
  throw FileError("the progress file was not written within " + numberText(patience_.count()) +
                  " s: its disk does not answer");
}

}  // namespace lamina
