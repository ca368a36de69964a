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
#include "lamina/streaming/journal/job_journal.hpp"
#include "streaming/journal/progress_file.hpp"
#include "streaming/session/session_kind.hpp"
#include "streaming/transport/deadline_timer.hpp"
#include "streaming/transport/http_client.hpp"
#include "streaming/upload/upload_job.hpp"

namespace lamina {
namespace {

/// The progress file of a print that a server runs by itself: the uploaded file, its name, and how much of it
/// the machine last reported as read. It is on disk before the print starts. If the disk fails the print goes
/// on without it.
class UploadJournal {
 public:
  /// @throws FileError if the program is gone
  UploadJournal(StreamJournal where, const StreamableProgram& program, const std::string& port);

  /// Stores the progress; to be called before the job's request is sent.
  void keep(const UploadJob& job);
  /// The job's status, completed by the last progress of a print that is gone and by a failure of the file.
  StreamStatus withWhatIsKnown(const UploadJob& job) const;

 private:
  void begin(const UploadJob& job);

  StreamJournal where_;
  JournalledJob job_;
  JobProgress kept_;
  std::unique_ptr<ProgressFile> file_;
  std::string failure_;
};

/// Whether the machine was lost from sight, and prints on.
bool isOutOfSight(const StreamStatus& status) {
  return status.failure.code == ErrorCode::Disconnected &&
         (status.state == PackmlState::Aborting || status.state == PackmlState::Aborted);
}

JobProgress progressOf(const StreamStatus& status) {
  JobProgress progress;
  progress.sent_through = status.lines_total;
  progress.taken_through = status.lines_acknowledged;
  progress.layer = status.layer;
  progress.state = isOutOfSight(status) ? PackmlState::Execute : status.state;
  return progress;
}

UploadJournal::UploadJournal(StreamJournal where, const StreamableProgram& program, const std::string& port)
    : where_(std::move(where)) {
  if (where_.path.empty()) return;
  job_ = describedJob(program, port);
  job_.execution = where_.unfinished ? where_.unfinished->job.execution : where_.execution;
}

void UploadJournal::begin(const UploadJob& job) {
  if (!where_.unfinished) keepUnfinished(where_.path);
  job_.protocol = job.firmware();
  job_.firmware_name = job.status().firmware_name;
  job_.uploaded_as = job.printedFile();
  file_ = std::make_unique<ProgressFile>(where_.path, job_, stampedNow(kept_));
}

void UploadJournal::keep(const UploadJob& job) {
  // What fails before the print may have been started leaves what was known of the one before.
  if (where_.path.empty() || !failure_.empty() || !(file_ || job.mayBeStarted())) return;
  const JobProgress known = progressOf(job.status());
  const bool is_kept = file_ && known.taken_through == kept_.taken_through && known.layer == kept_.layer &&
                       known.state == kept_.state;
  if (is_kept) return;
  kept_ = known;
  try {
    if (file_)
      file_->write(stampedNow(kept_));
    else
      begin(job);
  } catch (const Error& error) {
    failure_ = std::string(error.what()) + "; the print goes on, but how far it is is no longer kept";
    file_.reset();
  }
}

StreamStatus UploadJournal::withWhatIsKnown(const UploadJob& job) const {
  StreamStatus status = job.status();
  if (!failure_.empty()) status.message = failure_;
  const bool is_not_there = isFinal(status.state) && !job.mayBeStarted();
  if (where_.unfinished && is_not_there)
    status.failure.message += "; known is: " + describeProgress(*where_.unfinished);
  return status;
}

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
                StreamSession::Observer observer, SessionOptions options)
      : record_(port.name, std::move(observer)),
        journal_(std::move(options.journal), program, port.name),
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
    if (job_.takeBreak()) client_.breakOff();
    const auto request = job_.takeRequest(clock_.now());
    journal_.keep(job_);
    if (request) client_.ask(*request, order_->body);
    record_.publish(journal_.withWhatIsKnown(job_), job_.takeStateChanges(), clock_.now());
    if (!isFinal(job_.status().state)) return timer_.set(job_.nextDeadline());
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
  DeadlineTimer timer_;
  /// Until the job is over, so that the thread waits for commands.
  std::optional<boost::asio::executor_work_guard<boost::asio::io_context::executor_type>> work_;
  bool is_closed_ = false;
  std::thread thread_;
};

}  // namespace

std::unique_ptr<SessionKind> beginUpload(const StreamableProgram& program, const StreamSettings& settings,
                                         const MachinePort& port, StreamSession::Observer observer,
                                         SessionOptions options) {
  return std::make_unique<UploadSession>(program, settings, port, std::move(observer), std::move(options));
}

}  // namespace lamina
