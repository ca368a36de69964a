// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/session/stream_session.hpp"

#include <boost/asio/post.hpp>
#include <chrono>
#include <future>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

#include "base/threads/thread_priority.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "lamina/streaming/session/streamer.hpp"
#include "lamina/streaming/transport/transport.hpp"
#include "streaming/session/session_journal.hpp"
#include "streaming/session/session_kind.hpp"
#include "streaming/transport/deadline_timer.hpp"
#include "streaming/transport/http_client.hpp"

namespace lamina {
namespace {

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
    std::string output = streamer_.takeOutput();
    journal_.keep(streamer_, clock_.now());
    if (journal_.forbidsTheFirstLine() && !std::exchange(is_refused_, true)) {
      streamer_.abort({ErrorCode::FileError, journal_.failure()}, clock_.now());
      output = streamer_.takeOutput();  // in place of the first lines
    }
    if (!output.empty()) transport_->send(output);
    StreamStatus status = streamer_.status();
    if (!journal_.failure().empty() && !is_refused_) status.message = journal_.failure();
    if (is_refused_) status.lines_sent = 0;
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
  bool is_refused_ = false;  ///< no line may be sent, by the journal
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
