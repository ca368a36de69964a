// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/session/stream_session.hpp"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <chrono>
#include <cstdint>
#include <exception>
#include <future>
#include <limits>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

#include "base/threads/thread_priority.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "lamina/streaming/journal/job_journal.hpp"
#include "lamina/streaming/session/streamer.hpp"
#include "lamina/streaming/transport/transport.hpp"
#include "streaming/journal/journal_writer.hpp"
#include "streaming/session/session_kind.hpp"
#include "streaming/transport/deadline_timer.hpp"
#include "streaming/transport/http_client.hpp"

namespace lamina {
namespace {

/// The progress file of one session. If the disk fails the job goes on without it.
class SessionJournal {
 public:
  /// @throws FileError if the program is gone
  /// @param revision  of the lines, or null; progress of revised lines is kept only with a record of them
  SessionJournal(StreamJournal where, const StreamableProgram& program, const std::string& port,
                 std::shared_ptr<const ProgramRevision> revision);

  /// The order, completed by the first line number and the unfinished job.
  StreamOrder placed(StreamOrder order) const;
  /// Stores the progress; to be called before the streamer's output is sent.
  void keep(const Streamer& streamer, double now);
  /// Whether the link was lost and did not come back for the safe stop. The file then states no abort, and
  /// the job can be resumed on the machine that went on.
  bool isCutOff() const { return writer_ && is_cut_off_ && !is_stop_sent_; }
  /// Why progress is no longer stored; empty if it is.
  const std::string& failure() const { return failure_; }

 private:
  void begin(const Streamer& streamer);
  void followLink(const Streamer& streamer);
  /// As of a job that may have any number of lines, where it is revised.
  std::uint64_t mostLines() const;

  StreamJournal where_;
  JournalledJob job_;
  std::shared_ptr<const ProgramRevision> revision_;
  std::unique_ptr<JournalWriter> writer_;
  bool has_begun_ = false;
  bool is_cut_off_ = false;    ///< the link is lost
  bool is_stop_sent_ = false;  ///< a safe stop may have reached the machine
  std::string failure_;
};

constexpr std::uint64_t kFirstAhead = 256;  // lines

/// Seven digits: other senders count from 1, and an earlier job is unlikely to have been there; and a line
/// whose N is damaged into a G or M has a code that no firmware knows. Longer numbers would only slow down
/// the line.
std::uint64_t anyLineBase() {
  std::random_device source;
  return std::uniform_int_distribution<std::uint64_t>(1'000'000, 8'999'999)(source);
}

SessionJournal::SessionJournal(StreamJournal where, const StreamableProgram& program, const std::string& port,
                               std::shared_ptr<const ProgramRevision> revision)
    : where_(std::move(where)), revision_(std::move(revision)) {
  const std::optional<RevisionRecord> record = revision_ ? revision_->record() : std::nullopt;
  if (revision_ && !record) where_ = {};
  job_.line_base = anyLineBase();
  if (where_.path.empty()) return;
  if (where_.unfinished) {
    job_ = where_.unfinished->job;
    return;
  }
  const std::uint64_t line_base = job_.line_base;
  job_ = describedJob(program, port);
  job_.line_base = line_base;
  job_.revision = record;
  job_.execution = where_.execution;
}

std::uint64_t SessionJournal::mostLines() const {
  return job_.revision ? std::numeric_limits<std::uint64_t>::max() : job_.lines_total;
}

StreamOrder SessionJournal::placed(StreamOrder order) const {
  order.line_base = job_.line_base;
  if (!where_.unfinished) return order;
  const JobProgress& known = where_.unfinished->progress;
  order.unfinished = UnfinishedLines{known.taken_through, known.sent_through, job_.firmware_name};
  if (order.settings.firmware == kAnyFirmware) order.settings.firmware = job_.protocol;
  return order;
}

void SessionJournal::begin(const Streamer& streamer) {
  const StreamStatus& status = streamer.status();
  job_.protocol = streamer.protocol();
  job_.firmware_name = status.firmware_name;
  JobProgress known;
  known.taken_through = status.lines_acknowledged;
  known.sent_through = std::min(mostLines(), status.lines_sent + kFirstAhead);
  known.layer = status.layer;
  if (!where_.unfinished) keepUnfinished(where_.path);
  writer_ = std::make_unique<JournalWriter>(ProgressFile(where_.path, job_, known), known, mostLines());
}

void SessionJournal::followLink(const Streamer& streamer) {
  const PackmlState state = streamer.status().state;
  if (isFinal(state)) return;
  is_cut_off_ = streamer.isOffline();
  if (state == PackmlState::Aborting && !is_cut_off_) is_stop_sent_ = true;
}

void SessionJournal::keep(const Streamer& streamer, double now) {
  const PackmlState state = streamer.status().state;
  if (where_.path.empty() || !failure_.empty() || state == PackmlState::Idle ||
      state == PackmlState::Starting)
    return;
  try {
    // What fails before a line was sent leaves what was known of the job before.
    if (!std::exchange(has_begun_, has_begun_ || state == PackmlState::Execute)) {
      if (!has_begun_) return;
      begin(streamer);
    }
    followLink(streamer);
    StreamStatus status = streamer.status();
    if (isCutOff()) status.state = PackmlState::Execute;
    const std::string unrecorded = revision_ ? revision_->recordFailure() : std::string();
    // What is sent from now on cannot be made again: the job is none to go on with.
    if (!unrecorded.empty()) status.state = PackmlState::Aborted;
    writer_->record(status, now);
    if (!unrecorded.empty()) throw FileError("the corrections are not recorded: " + unrecorded);
  } catch (const std::exception& error) {  // of a file system too: a bad disk must not end the process
    failure_ = std::string(error.what()) + "; the job goes on, but could not be gone on with after a fault";
    writer_.reset();
  }
}

constexpr std::chrono::milliseconds kReopenInterval{200};

StreamSettings atPort(StreamSettings settings, const std::string& port) {
  if (settings.link == LinkKind::Auto) settings.link = linkOf(port);
  return settings;
}

/// A streamer and the link over which it speaks.
class LinkSession final : public SessionKind {
 public:
  LinkSession(const StreamableProgram& program, const StreamSettings& settings, MachinePort port,
              StreamSession::Observer observer, SessionOptions options)
      : port_(std::move(port)),
        record_(port_.name, std::move(observer)),
        journal_(std::move(options.journal), program, port_.name, options.revision),
        streamer_(journal_.placed({program,
                                   atPort(settings, port_.name),
                                   std::move(options.heard),
                                   {},
                                   0,
                                   {},
                                   0,
                                   std::move(options.revision)})),
        transport_(makeTransport(context_, port_.name, port_.baud)),
        timer_(context_, clock_, [this] { onDeadline(); }) {
    transport_->open(events());
    boost::asio::post(context_, [this] {
      streamer_.start(clock_.now());
      flush();
    });
    thread_ = std::thread([this] { run(); });
  }

  ~LinkSession() override {
    abort({ErrorCode::Cancelled, "the job was abandoned"});
    thread_.join();
  }

  void pause() override {
    command([this](double now) { streamer_.pause(now); });
  }
  void resume() override {
    command([this](double now) { streamer_.resume(now); });
  }
  std::string change(const LiveChange& change) override {
    if (isOver()) return kNoJobToChange;
    const auto refusal = std::make_shared<std::promise<std::string>>();
    command([this, change, refusal](double now) { refusal->set_value(streamer_.change(change, now)); });
    return answerOf(refusal->get_future());
  }
  void ask(const std::string& commands) override {
    command([this, commands](double now) {
      std::istringstream lines(commands);
      for (std::string line; std::getline(lines, line);)
        if (!line.empty()) streamer_.ask(line, now);
    });
  }
  void abort(const Failure& why) override {
    command([this, why](double now) { streamer_.abort(why, now); });
  }

  StreamStatus status() const override { return record_.status(); }
  bool isOver() const override { return record_.isOver(); }
  bool waitFor(double timeout_s) const override { return record_.waitFor(timeout_s); }

 private:
  TransportEvents events() {
    return {[this](std::string_view bytes) {
              streamer_.receive(bytes, clock_.now());
              flush();
            },
            [this](const std::string& why) {
              streamer_.disconnect("lost the link: " + why, clock_.now());
              flush();
            }};
  }

  /// Until the job is over; a link that was lost is opened again for the safe stop.
  void run() {
    preferThisThread();
    context_.run();
    while (!is_closed_) {
      std::this_thread::sleep_for(kReopenInterval);
      onDeadline();
      if (is_closed_ || !reopen()) continue;
      streamer_.reconnect(clock_.now());
      flush();
      context_.restart();
      context_.run();
    }
  }

  bool reopen() {
    try {
      transport_->open(events());
      return true;
    } catch (const Error&) {
      return false;  // tried again until the streamer gives up
    }
  }

  template <class Command>
  void command(Command command) {
    boost::asio::post(context_, [this, command] {
      command(clock_.now());
      flush();
    });
  }

  void onDeadline() {
    if (is_closed_) return;
    streamer_.elapse(clock_.now());
    flush();
  }

  /// Passes on what the streamer wants after each event.
  void flush() {
    if (is_closed_) return;
    const std::string output = streamer_.takeOutput();
    journal_.keep(streamer_, clock_.now());
    if (!output.empty()) transport_->send(output);
    StreamStatus status = streamer_.status();
    if (!journal_.failure().empty()) status.message = journal_.failure();
    if (isFinal(status.state) && journal_.isCutOff()) status.failure.message += remarkOnTheMachine();
    record_.publish(std::move(status), streamer_.takeStateChanges(), clock_.now());
    if (isFinal(streamer_.status().state)) {
      finish();
    } else if (streamer_.isOffline()) {
      timer_.cancel();
      transport_->close();
    } else {
      timer_.set(streamer_.nextDeadline());
    }
  }

  /// Of a machine that could not be reached for the safe stop.
  std::string remarkOnTheMachine() const {
    const bool can_resume = firmwareProtocols().find(streamer_.protocol())->canResume();
    return can_resume ? "; it was not stopped, and once it is reached again the job can be resumed"
                      : "; it was not stopped";
  }

  void finish() {
    is_closed_ = true;
    timer_.cancel();
    transport_->close();
    record_.finish();
  }

  SteadyClock clock_;
  boost::asio::io_context context_;
  MachinePort port_;
  SessionRecord record_;
  SessionJournal journal_;
  Streamer streamer_;
  std::unique_ptr<Transport> transport_;
  DeadlineTimer timer_;
  bool is_closed_ = false;
  std::thread thread_;
};

}  // namespace

bool isPrintServer(const MachinePort& port) { return isWebAddress(port.name); }

StreamJournal journalFor(const std::string& path, const StreamableProgram& program, const MachinePort& port,
                         JobStart start) {
  if (start == JobStart::New) return beginJournal(path);
  return isPrintServer(port) ? followJournal(path, program, port.name)
                             : resumeJournal(path, program, port.name);
}

StreamSession::StreamSession(const StreamableProgram& program, const StreamSettings& settings,
                             const MachinePort& port, Observer observer, SessionOptions options) {
  if (options.revision && (isPrintServer(port) || options.journal.unfinished))
    throw InvalidConfig(port.name +
                        (options.journal.unfinished
                             ? ": an unfinished job cannot go on with lines that are corrected"
                             : " prints by itself what it was sent whole") +
                        "; expected a job from its first line, sent line by line, for corrections");
  if (isPrintServer(port)) {
    kind_ = beginUpload(program, settings, port, std::move(observer), options);
  } else {
    kind_ = std::make_unique<LinkSession>(program, settings, port, std::move(observer), std::move(options));
  }
}
StreamSession::~StreamSession() = default;

void StreamSession::pause() { kind_->pause(); }
void StreamSession::resume() { kind_->resume(); }
std::string StreamSession::change(const LiveChange& change) { return kind_->change(change); }
void StreamSession::ask(const std::string& commands) { kind_->ask(commands); }
void StreamSession::abort(const Failure& why) { kind_->abort(why); }
StreamStatus StreamSession::status() const { return kind_->status(); }
bool StreamSession::isOver() const { return kind_->isOver(); }
bool StreamSession::waitFor(double timeout_s) const { return kind_->waitFor(timeout_s); }

void throwIfFailed(const StreamStatus& status) {
  const Failure& failure = status.failure;
  switch (failure.code) {
    case ErrorCode::Ok:
      return;
    case ErrorCode::InvalidInput:
      throw InvalidInput(failure.message);
    case ErrorCode::InvalidMesh:
      throw InvalidMesh(failure.message);
    case ErrorCode::InvalidConfig:
      throw InvalidConfig(failure.message);
    case ErrorCode::InvalidProgram:
      throw InvalidProgram(failure.message);
    case ErrorCode::FileError:
      throw FileError(failure.message);
    case ErrorCode::Unreachable:
      throw Unreachable(failure.message);
    case ErrorCode::DeviceError:
      throw DeviceError(failure.message);
    case ErrorCode::Disconnected:
      throw Disconnected(failure.message);
    case ErrorCode::Rejected:
      throw Rejected(failure.message);
    case ErrorCode::TimedOut:
      throw TimedOut(failure.message);
    case ErrorCode::Cancelled:
      throw Cancelled(failure.message);
    case ErrorCode::Internal:
      break;
  }
  throw Error(failure.code, failure.message);
}

}  // namespace lamina
