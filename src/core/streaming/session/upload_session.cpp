// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/text.hpp"
#include "streaming/session/session_kind.hpp"
#include "streaming/session/upload_journal.hpp"
#include "streaming/transport/deadline_timer.hpp"
#include "streaming/transport/http_client.hpp"
#include "streaming/upload/upload_job.hpp"

namespace lamina {
namespace {

constexpr double kJournalLook = 0.01;  // s between looks whether the progress file is on disk

/// The first line of the file that `stream.password_file` names.
std::string credentialFrom(const StreamSettings& settings) {
  if (settings.password_file.empty()) return {};
  const std::string text = InputFile(settings.password_file).readRest();
  return std::string(trimmed(std::string_view(text).substr(0, text.find('\n'))));
}

/// A name of our own, which no file there has: the program's, its checksum, the time and this process.
std::string fileStemFor(const ProgramBody& body) {
  constexpr std::size_t kLongestStem = 40;
  const std::string& name = body.program().name();
  std::string stem = name.substr(name.rfind('/') + 1);
  stem = stem.substr(0, std::min(stem.rfind('.'), kLongestStem));
  for (char& c : stem)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  std::array<char, 16> crc{};
  std::snprintf(crc.data(), crc.size(), "-%08x-", body.crc32());
  return "lamina/" + stem + crc.data();
}

std::string fileNameFor(const ProgramBody& body) {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  std::array<char, 64> tail{};
  std::snprintf(
      tail.data(), tail.size(), "%llx-%x.gcode",
      static_cast<unsigned long long>(std::chrono::duration_cast<std::chrono::milliseconds>(since).count()),
      static_cast<unsigned int>(::getpid()));
  return fileStemFor(body) + tail.data();
}

std::shared_ptr<const UploadOrder> orderFor(const StreamableProgram& program, const StreamSettings& settings,
                                            JobStart start) {
  ProgramBody body(program);
  std::string file = fileNameFor(body);
  std::string earlier = fileStemFor(body);
  return std::make_shared<const UploadOrder>(
      UploadOrder{std::move(body), std::move(file), credentialFrom(settings), settings.silence_timeout_s,
                  settings.connect_timeout_s, start, std::move(earlier)});
}

/// An upload job and the client that asks its questions.
class UploadSession final : public SessionKind {
 public:
  UploadSession(const StreamableProgram& program, const StreamSettings& settings, const MachinePort& port,
                StreamSession::Observer observer, const SessionOptions& options)
      : record_(port.name, std::move(observer)),
        journal_(options.journal, program, port.name),
        order_(orderFor(program, settings, options.start)),
        job_(settings, order_),
        client_(context_, httpAddressOf(port.name), events()),
        timer_(context_, clock_, [this] { onDeadline(); }) {
    client_.open();
    work_.emplace(context_.get_executor());
    command([this](double now) { job_.start(now); });
    thread_ = std::thread([this] { context_.run(); });
  }
  ~UploadSession() override {
    abort({ErrorCode::Cancelled, "the job was abandoned"});
    thread_.join();
  }

  void pause() override {
    command([this](double now) { job_.pause(now); });
  }
  void resume() override {
    command([this](double now) { job_.resume(now); });
  }
  /// A print server says nothing else than how its print is.
  void ask(const std::string& /*commands*/) override {}
  std::string change(const LiveChange& change) override {
    if (isOver()) return kNoJobToChange;
    const auto refusal = std::make_shared<std::promise<std::string>>();
    command([this, change, refusal](double now) { refusal->set_value(job_.change(change, now)); });
    return answerOf(refusal->get_future());
  }
  void abort(const Failure& why) override {
    command([this, why](double now) { job_.abort(why, now); });
  }
  StreamStatus status() const override { return record_.status(); }
  bool isOver() const override { return record_.isOver(); }
  bool waitFor(double timeout_s) const override { return record_.waitFor(timeout_s); }

 private:
  HttpEvents events() {
    return {[this](std::uint64_t bytes) {
              job_.sent(bytes);
              flush();
            },
            [this](const HttpResponse& response) {
              job_.receive(response, clock_.now());
              flush();
            },
            [this](const HttpFailure& failure) {
              job_.fail(failure, clock_.now());
              flush();
            }};
  }

  template <class Command>
  void command(Command command) {
    boost::asio::post(context_, [this, command] {
      command(clock_.now());
      flush();
    });
  }

  void onDeadline() {
    job_.elapse(clock_.now());
    flush();
  }

  /// Passes on what the job wants after each event.
  void flush() {
    if (is_closed_) return;
    const double now = clock_.now();
    if (job_.takeBreak()) {
      client_.breakOff();
      waiting_.reset();
    }
    if (auto request = job_.takeRequest(now)) waiting_ = std::move(request);
    journal_.keep(job_, now);
    if (waiting_ && !journal_.prohibition().empty() && !std::exchange(is_refused_, true)) {
      waiting_.reset();
      job_.abort({ErrorCode::FileError, journal_.prohibition()}, now);
      job_.takeBreak();  // nothing was asked
      if (auto request = job_.takeRequest(now)) waiting_ = std::move(request);
    }
    const bool must_wait = waiting_ && journal_.isAwaited(job_);
    if (waiting_ && !must_wait) client_.ask(*std::exchange(waiting_, std::nullopt), order_->body);
    record_.publish(journal_.withWhatIsKnown(job_), job_.takeStateChanges(), now);
    if (!isFinal(job_.status().state))
      return timer_.set(must_wait ? std::min(now + kJournalLook, job_.nextDeadline()) : job_.nextDeadline());
    is_closed_ = true;
    timer_.cancel();
    client_.breakOff();
    work_.reset();
    record_.finish();
  }

  SteadyClock clock_;
  boost::asio::io_context context_;
  SessionRecord record_;
  UploadJournal journal_;
  std::shared_ptr<const UploadOrder> order_;
  UploadJob job_;
  HttpClient client_;
  std::optional<HttpRequest> waiting_;  ///< until the progress file states what it begins
  DeadlineTimer timer_;
  /// Until the job is over, so that the thread waits for commands.
  std::optional<boost::asio::executor_work_guard<boost::asio::io_context::executor_type>> work_;
  bool is_refused_ = false;  ///< the print must not be started, by the journal
  bool is_closed_ = false;
  std::thread thread_;
};

}  // namespace

std::unique_ptr<SessionKind> beginUpload(const StreamableProgram& program, const StreamSettings& settings,
                                         const MachinePort& port, StreamSession::Observer observer,
                                         const SessionOptions& options) {
  return std::make_unique<UploadSession>(program, settings, port, std::move(observer), options);
}

}  // namespace lamina
